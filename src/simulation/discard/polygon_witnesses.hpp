// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/discard/watch_lists.hpp"
#include "simulation/reach/reach_map.hpp"

#include <functional>
#include <span>
#include <vector>

namespace frostfill
{

/// The polygons of a surface that can still be touched, each with a cube from which it can.
class PolygonWitnesses
{
public:
    /// Whether a reached cube may hold a place; several threads ask at once.
    using MayHold = std::function<bool(int x, int y, int z)>;
    /// Whether it is known to, so that it need not be asked.
    using IsHeld = std::function<bool(CubeNumber)>;

    /// The surface outlives this. None has a cube yet.
    explicit PolygonWitnesses(const Surface& surface);

    /// Takes out the polygons that cannot be touched from any reached cube that may hold a place.
    /// The set of those only shrinks from call to call.
    [[nodiscard]] std::vector<std::uint32_t> takeUntouchable(
        const ReachMap& map, Threads& threads, const MayHold& mayHold,
        const IsHeld& isHeld = [](CubeNumber) { return false; });

private:
    using Watchers = std::span<WatchLists::Watcher>;

    [[nodiscard]] std::uint32_t polygon(const WatchLists::Watcher& one) const
    {
        return surface_->tree().order()[one.obstacle];
    }
    void findWitnesses(const ReachMap& map, const MayHold& mayHold, Watchers polygons) const;

    const Surface* surface_;
    WatchLists lists_; ///< of polygons, by their place in the surface's tree
};

} // namespace frostfill

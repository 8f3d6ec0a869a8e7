// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/world/world.hpp"

#include <memory>

namespace frostfill
{

/// A discard rule: which spheres at rest and which polygons are not tested any more. It marks them
/// with Spheres::discard and World::discardPolygon, and does in each of these calls what it wants
/// to.
class DiscardPart
{
public:
    virtual ~DiscardPart() = default;

    /// A sphere has come to rest.
    virtual void addResting(std::uint32_t /*id*/) {}
    /// One of those that were added since the last afterStep() runs again.
    virtual void takeBack(std::uint32_t /*id*/) {}
    /// A sphere has got another id.
    virtual void renumber(std::uint32_t /*from*/, std::uint32_t /*to*/) {}
    /// Spheres have been frozen, for now no more.
    virtual void afterFreezing() {}
    /// A step is over. Returns whether what was discarded has come back.
    [[nodiscard]] virtual bool afterStep() { return false; }
    /// Nothing runs any more. `full`: no further sphere fits.
    virtual void finish(bool /*full*/) {}
};

/// The one that the world's scene asks for; empty when nothing is to be discarded. Its time counts
/// as that of discarding. World and threads outlive the part.
[[nodiscard]] std::unique_ptr<DiscardPart> makeDiscard(World& world, Threads& threads);

/// The same when all spheres rest, which it then knows.
[[nodiscard]] std::unique_ptr<DiscardPart> makeDiscardAtRest(World& world, Threads& threads);

} // namespace frostfill

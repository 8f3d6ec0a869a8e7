// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/spheres.hpp"

#include <frostfill/scene.hpp>

#include <memory>
#include <span>

namespace frostfill
{

/// Spheres with ids from `begin` to before `end`. In the preset paper all come to rest in the order
/// of their ids, so that the id of one at rest is also its row.
struct IdRange
{
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// A sphere search: which spheres at rest a running one is tested with in cycle 2 of Algorithm 1.
/// It is asked once a sphere and step. Preset paper.
class SphereSearchPart
{
public:
    virtual ~SphereSearchPart() = default;

    /// Those of `frozen` that the sphere in running row `i` is tested with, as ranges in ascending
    /// order: at least all that it may touch, also after the others have pushed it by up to the
    /// largest radius. Valid until the next call.
    [[nodiscard]] virtual std::span<const IdRange> near(const Spheres& spheres, std::uint32_t i,
                                                        IdRange frozen) = 0;
};

/// `resting`: a grid of all spheres at rest, kept up to date, which outlives the part.
[[nodiscard]] std::unique_ptr<SphereSearchPart> makeSphereSearch(SphereSearch search,
                                                                 const SphereGrid& resting);

} // namespace frostfill

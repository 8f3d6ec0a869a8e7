// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/reach/open_cubes.hpp"
#include "simulation/world/world.hpp"

#include <optional>
#include <vector>

namespace frostfill
{

/// See frostfill::inspectReach: of a run's object and its smallest radius, with the searches that
/// it has anyway. `open` gets the open cubes of the object, if they are known.
[[nodiscard]] ReachInspection inspectReach(const World& world, std::size_t bytes,
                                           std::optional<OpenCubes>& open);

/// What of an object spheres of a radius cannot fill.
struct UnfilledSpace
{
    double volume = 0;                    ///< that no sphere covers, crumbs included [r^3]
    std::vector<UnreachableVolume> parts; ///< connected, largest first [r]
};

/// Cubes inside the object whose middle is farther from every open cube than the probe.
/// `unblocked`: see openCubesOf; `inside`: of them those inside of the surface. Parts smaller than
/// `smallestPart` [r^3] are left out.
[[nodiscard]] UnfilledSpace unfilledSpace(const OpenCubes& open, const CubeSet& unblocked,
                                          const CubeSet& unblockedInside, const InsideTest& inside,
                                          double smallestPart, Threads& threads);

} // namespace frostfill

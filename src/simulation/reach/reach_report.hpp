// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/reach/reach_map.hpp"

namespace frostfill
{

/// A part of the object that no sphere can cover.
struct UnreachablePart
{
    double volume = 0;      ///< [r^3]
    Eigen::Vector3d centre; ///< centre of mass; may lie outside a bent part
    Eigen::AlignedBox3d box;
};

/// What of the object spheres of a radius cannot fill.
struct ReachReport
{
    double unreachedVolume = 0;         ///< that no sphere covers, crumbs included [r^3]
    std::vector<UnreachablePart> parts; ///< largest first, of at least the volume asked for
    double resolution = 0;              ///< edge of a cube [r]
};

/// Cubes inside the object whose middle is farther from every reached cube than the smallest
/// radius, as connected parts. Depends on the seeds of the map: with seeds at the top only, what
/// hangs behind a narrow neck counts as unreachable, with seeds everywhere only the neck does.
/// `unblocked`: what the map had when it was made. `smallestPart` [r^3]: smaller parts are left
/// out. An inactive map has nothing to report.
[[nodiscard]] ReachReport reportReach(const ReachMap& map, const ReachMap::Unblocked& unblocked,
                                      const InsideTest& inside, double smallestPart,
                                      Threads& threads);

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"

#include <algorithm>

namespace frostfill
{

/// Distance to the nearest triangle, by trying all.
inline double distanceToSurface(const Surface& surface, const Eigen::Vector3d& p)
{
    double nearest = 1e300;
    for (const SurfaceTriangle& t : surface.triangles())
    {
        nearest = std::min(
            nearest,
            (closestPointOnTriangle(p, t.corner[0], t.corner[1], t.corner[2]).point - p).norm());
    }
    return nearest;
}

} // namespace frostfill

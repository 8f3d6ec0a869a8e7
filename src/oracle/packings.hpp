// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <numbers>
#include <vector>

/// Lattices of touching spheres of radius 1.
namespace frostfill::oracle
{

struct Packing
{
    std::vector<Eigen::Vector3d> places;
    double fraction = 0; ///< of space that is inside spheres
    double contacts = 0; ///< of each sphere
};

/// The spheres of a simple cubic lattice that lie inside a cube of an even half edge, around 0.
[[nodiscard]] inline Packing simpleCubic(int halfEdge)
{
    Packing packing{{}, std::numbers::pi / 6, 6};
    for (int x = 1 - halfEdge; x < halfEdge; x += 2)
    {
        for (int y = 1 - halfEdge; y < halfEdge; y += 2)
        {
            for (int z = 1 - halfEdge; z < halfEdge; z += 2)
            {
                packing.places.emplace_back(x, y, z);
            }
        }
    }
    return packing;
}

/// The spheres of a face-centred cubic lattice that lie inside a cube around 0, one of them there:
/// as dense as can be.
[[nodiscard]] inline Packing faceCentredCubic(int halfEdge)
{
    Packing packing{{}, std::numbers::pi / std::sqrt(18.0), 12};
    const int most = static_cast<int>((halfEdge - 1) / std::numbers::sqrt2);
    for (int x = -most; x <= most; ++x)
    {
        for (int y = -most; y <= most; ++y)
        {
            for (int z = -most; z <= most; ++z)
            {
                if ((x + y + z) % 2 == 0)
                {
                    packing.places.emplace_back(std::numbers::sqrt2 * Eigen::Vector3d(x, y, z));
                }
            }
        }
    }
    return packing;
}

} // namespace frostfill::oracle

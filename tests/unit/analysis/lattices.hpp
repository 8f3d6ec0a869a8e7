// SPDX-License-Identifier: MIT
#pragma once

#include "support/shapes.hpp"

#include <frostfill/packing.hpp>

#include <cmath>
#include <vector>

/// Spheres in regular places, of which everything is known.
namespace frostfill::test
{

struct Lattice
{
    const char* name;
    std::vector<Eigen::Vector3d> basis; ///< [edge of the cube that repeats]
    double edge;                        ///< [diameter] of the cube in which spheres touch
    double neighbours;                  ///< that touch a sphere
    double secondShell;                 ///< spheres up to the second nearest, all told
    double secondDistance;              ///< [diameter]
    double bonded;                      ///< spheres within 1.3 diameters
    double q6;                          ///< of those [Steinhardt et al. 1983]
    double fraction;                    ///< of the volume
};

inline const std::vector<Lattice>& lattices()
{
    const double pi = std::numbers::pi;
    static const std::vector<Lattice> all = {
        {"sc", {{0, 0, 0}}, 1, 6, 18, std::sqrt(2.0), 6, std::sqrt(2.0) / 4, pi / 6},
        {"bcc",
         {{0, 0, 0}, {0.5, 0.5, 0.5}},
         2 / std::sqrt(3.0),
         8,
         14,
         2 / std::sqrt(3.0),
         14,
         0.510688230856951,
         pi * std::sqrt(3.0) / 8},
        {"fcc",
         {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}},
         std::sqrt(2.0),
         12,
         18,
         std::sqrt(2.0),
         12,
         13 * std::sqrt(2.0) / 32,
         pi / (3 * std::sqrt(2.0))},
    };
    return all;
}

inline const Eigen::Vector3d kCorner(0.3, -2, 7); // so that no coordinate is a round number

/// `times` cubes along each axis, and the box around them in which their spheres have room.
inline Packing packingOf(const Lattice& lattice, int times, double diameter)
{
    Packing packing;
    const double edge = lattice.edge * diameter;
    for (int z = 0; z < times; ++z)
    {
        for (int y = 0; y < times; ++y)
        {
            for (int x = 0; x < times; ++x)
            {
                for (const Eigen::Vector3d& place : lattice.basis)
                {
                    packing.centres.push_back(kCorner + edge * (Eigen::Vector3d(x, y, z) + place) +
                                              Eigen::Vector3d::Constant(diameter / 2));
                }
            }
        }
    }
    packing.radii.assign(packing.centres.size(), diameter / 2);
    packing.atRest.assign(packing.centres.size(), true);
    return packing;
}

/// From the lowest spheres to the highest ones, with nothing between them and the walls.
inline TriangleMesh boxAround(const Packing& packing)
{
    Eigen::AlignedBox3d box;
    for (std::size_t k = 0; k < packing.centres.size(); ++k)
    {
        box.extend(packing.centres[k] - Eigen::Vector3d::Constant(packing.radii[k]));
        box.extend(packing.centres[k] + Eigen::Vector3d::Constant(packing.radii[k]));
    }
    return shapes::box(box.min(), box.max());
}

} // namespace frostfill::test

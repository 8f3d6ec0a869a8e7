// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

namespace frostfill
{

/// A packing far from walls.
struct BulkPacking
{
    double fraction = 0;     ///< [1] of the volume that lies inside spheres
    double contacts = 0;     ///< mean number a sphere of gaps below 1 % of a diameter
    std::size_t spheres = 0; ///< whose centres are there
};

/// Of the spheres in the object's box less a margin [r] on every side. The volume of spheres that
/// the cut passes through is counted by subdivision, with an error of about 1e-4.
[[nodiscard]] BulkPacking bulkPacking(const World& world, double margin);

} // namespace frostfill

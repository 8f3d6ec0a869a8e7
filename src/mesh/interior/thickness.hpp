// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_bvh.hpp"

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <vector>

namespace frostfill
{

/// A place of the surface, for the part of the surface and of the interior around it.
struct ThicknessSample
{
    double thickness = 0; ///< [unit] radius of the largest ball inside that covers the middle of it
    double area = 0;      ///< [unit^2] that it stands for, of one side
    double volume = 0;    ///< [unit^3] that it stands for
};

/// How thick an object is, from place to place: [Hildebrand & Rueegsegger 1997], by balls that
/// touch the surface from inside [Ma et al. 2012]. `mesh` is closed and may cross itself; where the
/// interior is on both sides of a wall, both have a sample. Deterministic. Takes
/// O(samples^2 + #T log #T). `onlyBehind`: the interior is known to be behind every triangle.
/// `tree`: of the mesh.
[[nodiscard]] std::vector<ThicknessSample> sampleThickness(const TriangleMesh& mesh,
                                                           const TriangleBvh& tree,
                                                           std::size_t samples, bool onlyBehind);

} // namespace frostfill

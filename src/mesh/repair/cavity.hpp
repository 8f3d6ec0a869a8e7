// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// What the walls of a closed mesh enclose without filling it: closed shells within another, and
/// the insides of vessels that are open, such as cups and hoppers.
struct Cavity
{
    TriangleMesh surface;  ///< the walls' triangles that face it, turned to be wound outwards
    double volume = 0;     ///< [unit^3] with lids
    double areaOfLids = 0; ///< [unit^2]
    bool hasClosedPart = false;
};

/// Of a mesh that repairMesh has returned. Parts much smaller than the largest do not count. A
/// vessel's opening is found as far as cubes resolve it, a 64th of the mesh's size.
[[nodiscard]] Cavity findCavity(const TriangleMesh& walls);

} // namespace frostfill

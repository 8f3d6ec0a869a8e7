// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// The space that the walls of a closed mesh enclose but do not fill: closed shells within another,
/// and the insides of open vessels, such as cups and hoppers.
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

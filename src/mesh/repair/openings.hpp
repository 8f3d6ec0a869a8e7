// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// A lid that was put on an opening.
struct LidReport
{
    std::size_t edges = 0;                            ///< of the rim
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< mean of the vertices of the rim
    double area = 0;                                  ///< [unit^2] of the lid
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< [unit^2] sum of its areas
};

struct ClosedOpenings
{
    std::vector<LidReport> lids;
    std::size_t lidTriangles = 0;   ///< the last of the mesh
    std::size_t sheetTriangles = 0; ///< removed: of patches that enclose nothing with lids
    std::size_t walls = 0;          ///< triangles of walls within, which are doubled
    std::size_t turnedPatches = 0;  ///< wound against the patches that they touch
};

/// Closes all openings of a consistently wound mesh, however large. Patches that meet at edges of
/// three triangles, or others that do not cancel, get lids of their own. Sheets, patches that
/// enclose nothing with lids, come out first: fins and flaps go; walls that others hold all around
/// become double, one side for each room. If there is nothing but sheets, or the surface is
/// one-sided, the mesh stays as it is.
[[nodiscard]] ClosedOpenings closeOpenings(TriangleMesh& mesh);

} // namespace frostfill

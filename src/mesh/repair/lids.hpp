// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/repair/rims.hpp"
#include "mesh/triangle_shape.hpp"

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// A lid over any rim, in the direction of the rim: of least area if the rim is short; else the
/// rim's picture in a plane cut into triangles; else a fan about the middle, which adds a vertex.
/// It may cross the mesh, and the fan itself: the windings cancel at every edge all the same.
[[nodiscard]] std::vector<Triangle> lidOver(TriangleMesh& mesh, const EdgeTable& edges,
                                            const Rim& rim);

/// The rim cut into triangles as a polygon (PolygonCutter). Empty where a part of the rim goes the
/// other way round in the rim's plane, or a triangle without area or a chord that is an edge of the
/// mesh already would be needed.
[[nodiscard]] std::vector<Triangle> clippedLid(const TriangleMesh& mesh, const EdgeTable& edges,
                                               const Rim& rim);

struct Hole
{
    std::size_t edges = 0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< mean of the vertices of the rim
    double share = 0; ///< [1] area of the lid over that of the surface; 0 if there is no lid
    bool closed = false;
    bool ofSheet = false; ///< with lids, the piece around it would enclose nothing
};

/// Closes each small hole of a consistently wound mesh with a lid of least area. Adds no vertex.
/// Returns all holes; `closed` is false for holes that are too large, whose rim allows no lid, or
/// that are the rim of a sheet, which a lid would make an envelope without volume.
std::vector<Hole> closeHoles(TriangleMesh& mesh);

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

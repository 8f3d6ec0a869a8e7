// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/repair/rims.hpp"
#include "mesh/triangle_shape.hpp"

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

} // namespace frostfill

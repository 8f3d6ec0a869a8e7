// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

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

// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

struct Hole
{
    std::size_t edges = 0;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< mean of the rim's vertices
    double share = 0; ///< [1] of the surface that a lid takes; 0 when none can be made
    bool closed = false;
};

/// Puts a lid of least area on each small hole of a consistently wound mesh. No vertex is added.
/// Returns all holes, with those that were too large or whose rim allows no lid marked open.
std::vector<Hole> closeHoles(TriangleMesh& mesh);

} // namespace frostfill

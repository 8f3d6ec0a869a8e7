// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <vector>

namespace frostfill
{

/// Boxes of the parts of a mesh, at least `gap` apart along some axis; ascending in x. Pieces that
/// are nearer to each other are one part.
[[nodiscard]] std::vector<Eigen::AlignedBox3d> separateBoxes(const TriangleMesh& mesh, double gap);

/// The part of the mesh in each of the boxes.
[[nodiscard]] std::vector<TriangleMesh>
separateParts(const TriangleMesh& mesh, const std::vector<Eigen::AlignedBox3d>& boxes);

} // namespace frostfill

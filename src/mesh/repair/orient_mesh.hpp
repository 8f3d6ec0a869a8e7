// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <optional>

namespace frostfill
{

/// Turns triangles until neighbours agree, the fewer of each piece. Returns how many were turned.
/// A one-sided surface keeps inconsistent edges.
std::size_t makeWindingConsistent(TriangleMesh& mesh);

/// Turns whole pieces of a closed, consistent mesh: outer surfaces outwards, and a surface inside
/// another one (a cavity) the other way, by its depth of nesting. Returns how many were turned.
std::size_t turnPiecesOutward(TriangleMesh& mesh);

/// A place where one closed piece passes through another, judged by vertices of either that lie
/// inside and outside of the other.
[[nodiscard]] std::optional<Eigen::Vector3d> findCrossingPieces(const TriangleMesh& mesh);

} // namespace frostfill

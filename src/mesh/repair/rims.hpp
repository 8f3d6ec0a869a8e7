// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/edge_table.hpp"

#include <map>

namespace frostfill
{

/// Directed edges: from a vertex to the next ones.
using NextVertices = std::multimap<std::uint32_t, std::uint32_t>;
using Rim = std::vector<std::uint32_t>; ///< vertices around a hole

/// The rims, in the direction of the lids, each without repeated vertices. A path that does not
/// close, because it ends at an edge of three triangles, is no rim.
[[nodiscard]] std::vector<Rim> findRims(const EdgeTable& edges);

/// Between a point and a cone from the rim's middle. Any lid over a flat rim adds as much.
[[nodiscard]] double volumeOfLid(const TriangleMesh& mesh, const Rim& rim,
                                 const Eigen::Vector3d& origin);

/// Mean of the vertices.
[[nodiscard]] Eigen::Vector3d middleOf(const TriangleMesh& mesh, const Rim& rim);

/// The closed paths along these edges, each without repeated vertices. Where as many edges enter
/// each vertex as leave it, all edges are in one.
[[nodiscard]] std::vector<Rim> closedPaths(NextVertices next);

} // namespace frostfill

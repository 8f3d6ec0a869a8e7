// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <span>

namespace frostfill
{

/// Winding number of some of the triangles about a point.
[[nodiscard]] double windingNumber(const TriangleMesh& mesh,
                                   std::span<const std::uint32_t> triangles,
                                   const Eigen::Vector3d& point);

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <span>

namespace frostfill
{

/// A point is inside where the winding number is larger: halfway between the 0 outside and the 1
/// inside, which are all that a closed mesh has. A mesh with holes has values in between, and a
/// larger bound would take more of the space beside its holes for outside [Jacobson et al. 2013].
inline constexpr double kInsideFrom = 0.5;

/// [4 pi] Signed solid angle of a triangle seen from a point: at most 1/2, and finite everywhere.
[[nodiscard]] double solidAngle(const TriangleMesh& mesh, std::size_t triangle,
                                const Eigen::Vector3d& point);

/// Winding number of some of the triangles about a point.
[[nodiscard]] double windingNumber(const TriangleMesh& mesh,
                                   std::span<const std::uint32_t> triangles,
                                   const Eigen::Vector3d& point);

} // namespace frostfill

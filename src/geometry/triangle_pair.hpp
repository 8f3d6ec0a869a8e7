// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>

namespace frostfill
{

/// Two triangles of a surface, with the corners that they share in front and in the same order.
/// Both have an area. Corners with equal coordinates need not be shared: two sheets may touch
/// there.
struct TrianglePair
{
    using Corners = std::array<Eigen::Vector3d, 3>;

    Corners a;
    Corners b;
    int shared = 0; ///< 0 to 3 corners
};

/// Whether the corners do not lie on a line. Exact.
[[nodiscard]] bool hasArea(const TrianglePair::Corners& triangle);

/// Whether the triangles have a point in common that belongs to no shared corner or edge. To touch
/// is to cross. Exact, see orient3d.
[[nodiscard]] bool trianglesCross(const TrianglePair& pair);

/// The middle of what two triangles that cross have in common, rounded.
[[nodiscard]] Eigen::Vector3d crossingPlace(const TrianglePair& pair);

} // namespace frostfill

// SPDX-License-Identifier: MIT
// Room: geometry of single triangles, boxes and grids. Nothing here knows of a whole mesh.
#pragma once

#include <Eigen/Geometry>

#include <cstdint>

namespace frostfill
{

/// Which part of a triangle a point is closest to. Edge k runs from corner k to corner k + 1.
enum class TriangleFeature : std::uint8_t
{
    corner0,
    corner1,
    corner2,
    edge0,
    edge1,
    edge2,
    face,
};

struct ClosestPoint
{
    Eigen::Vector3d point;
    TriangleFeature feature = TriangleFeature::face;
};

/// Closest point of the triangle abc to p, by the Voronoi regions of its features
/// [Ericson 2005, 5.1.5].
[[nodiscard]] ClosestPoint closestPointOnTriangle(const Eigen::Vector3d& p,
                                                  const Eigen::Vector3d& a,
                                                  const Eigen::Vector3d& b,
                                                  const Eigen::Vector3d& c);

} // namespace frostfill

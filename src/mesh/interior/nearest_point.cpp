// SPDX-License-Identifier: MIT
#include "mesh/interior/nearest_point.hpp"

#include "geometry/closest_point.hpp"

#include <cmath>

namespace frostfill
{

std::optional<NearestPoint::Place> NearestPoint::find(const Eigen::Vector3d& p, double within) const
{
    std::optional<Place> found;
    double least = within * within;
    const auto visit = [&](std::span<const std::uint32_t> triangles)
    {
        for (const std::uint32_t triangle : triangles)
        {
            const auto& [a, b, c] = mesh_->triangles[triangle];
            const Eigen::Vector3d point =
                closestPointOnTriangle(p, mesh_->vertices[a], mesh_->vertices[b],
                                       mesh_->vertices[c])
                    .point;
            const double square = (point - p).squaredNorm();
            if (square < least || (found && square == least && triangle < found->triangle))
            {
                least = square;
                found = {point, triangle, std::sqrt(square)};
            }
        }
        return std::sqrt(least);
    };
    bvh_.forEachNear(Eigen::AlignedBox3d(p), within, visit);
    return found;
}

} // namespace frostfill

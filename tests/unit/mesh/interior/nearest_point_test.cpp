// SPDX-License-Identifier: MIT
#include "geometry/closest_point.hpp"
#include "mesh/interior/triangle_bvh.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace frostfill
{
namespace
{

double distanceToAll(const TriangleMesh& mesh, const Eigen::Vector3d& p)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : mesh.triangles)
    {
        const Eigen::Vector3d point =
            closestPointOnTriangle(p, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]).point;
        least = std::min(least, (point - p).norm());
    }
    return least;
}

TEST(NearestPoint, IsTheNearestOfAllTrianglesHoweverFar)
{
    const TriangleMesh torus = shapes::torus();
    const TriangleBvh tree(torus);
    for (int k = 0; k < 200; ++k)
    {
        const Eigen::Vector3d p(3 * std::sin(1.7 * k), 2 * std::sin(2.3 * k), std::sin(0.9 * k));
        const auto found = nearestPoint(torus, tree, p, 100);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->distance, distanceToAll(torus, p), 1e-14);
        EXPECT_NEAR((found->point - p).norm(), found->distance, 1e-14);
        const auto& [a, b, c] = torus.triangles[found->triangle];
        const Eigen::Vector3d there =
            closestPointOnTriangle(p, torus.vertices[a], torus.vertices[b], torus.vertices[c])
                .point;
        EXPECT_EQ(there, found->point);
    }
}

TEST(NearestPoint, IsNothingWhenAllIsFartherThanAsked)
{
    const TriangleMesh cube = shapes::box({0, 0, 0}, {1, 1, 1});
    const TriangleBvh tree(cube);
    EXPECT_FALSE(nearestPoint(cube, tree, {0.5, 3, 0.5}, 1.99));
    EXPECT_TRUE(nearestPoint(cube, tree, {0.5, 3, 0.5}, 2.01));
    EXPECT_FALSE(nearestPoint({}, TriangleBvh(TriangleMesh()), {0, 0, 0}, 1));
}

} // namespace
} // namespace frostfill

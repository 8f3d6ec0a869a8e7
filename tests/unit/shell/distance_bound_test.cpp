// SPDX-License-Identifier: MIT
#include "geometry/closest_point.hpp"
#include "shell/simplified_shell.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& by)
{
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex += by;
    }
    return mesh;
}

TEST(DistanceBound, OfABoxInABoxIsTheClosedForm)
{
    // The corners of the larger one are farthest: a cube's diagonal away.
    const TriangleMesh inner = shapes::box({0, 0, 0}, {1, 1, 1}, 3);
    const TriangleMesh outer = shapes::box({-0.1, -0.1, -0.1}, {1.1, 1.1, 1.1});
    const double diagonal = 0.1 * std::sqrt(3.0);
    const auto out = distanceBound(outer, inner, 1);
    ASSERT_TRUE(out);
    EXPECT_GE(out->distance, diagonal - 1e-12);
    EXPECT_LE(out->distance, 1.1 * diagonal);
    const auto in = distanceBound(inner, outer, 1);
    ASSERT_TRUE(in);
    EXPECT_GE(in->distance, 0.1 - 1e-12);
    EXPECT_LE(in->distance, 0.11 + 1e-12);
}

TEST(DistanceBound, SeesWhatIsFarInTheMiddleOfATriangleAlone)
{
    // One large triangle over a sheet with a pit: corners and middle touch, the pit's side does
    // not.
    TriangleMesh flat;
    flat.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    flat.triangles = {{0, 1, 2}};
    TriangleMesh pit;
    pit.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0.5, 2, -1}, {0, 0.5, 0}, {0, 3.5, 0}};
    pit.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const auto bound = distanceBound(flat, pit, 10);
    ASSERT_TRUE(bound);
    double sampled = 0;
    for (int i = 0; i <= 100; ++i)
    {
        for (int j = 0; i + j <= 100; ++j)
        {
            const Eigen::Vector3d p(0.04 * i, 0.04 * j, 0);
            double least = 100;
            for (const auto& [a, b, c] : pit.triangles)
            {
                least = std::min(least, (closestPointOnTriangle(p, pit.vertices[a], pit.vertices[b],
                                                                pit.vertices[c])
                                             .point -
                                         p)
                                            .norm());
            }
            sampled = std::max(sampled, least);
        }
    }
    EXPECT_GE(bound->distance, sampled);
    EXPECT_LE(bound->distance, 1.12 * sampled);
}

TEST(DistanceBound, IsEmptyWhereTheLimitIsReached)
{
    const TriangleMesh cube = shapes::box({0, 0, 0}, {1, 1, 1});
    EXPECT_TRUE(distanceBound(cube, moved(cube, {0.05, 0, 0}), 0.06));
    EXPECT_FALSE(distanceBound(cube, moved(cube, {0.05, 0, 0}), 0.04));
}

TEST(DistanceBound, NamesTheTriangleNearestToEachMiddle)
{
    const TriangleMesh torus = shapes::torus();
    const auto bound = distanceBound(torus, torus, 0.1);
    ASSERT_TRUE(bound);
    EXPECT_LT(bound->distance, 1e-3);
    for (std::uint32_t t = 0; t < torus.triangles.size(); ++t)
    {
        EXPECT_EQ(bound->nearest[t], t);
    }
}

} // namespace
} // namespace frostfill

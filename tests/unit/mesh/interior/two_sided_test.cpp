// SPDX-License-Identifier: MIT
#include "mesh/interior/inside_test.hpp"
#include "support/random_points.hpp"
#include "support/winding_number.hpp"
#include "unit/mesh/interior/surface_samples.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// Two boxes that overlap, in triangles so small that the lists of cells are long, or so large that
/// they are short.
TriangleMesh overlappingBoxes(int refinements)
{
    TriangleMesh mesh = test::refined(test::box(0, 6), refinements);
    test::append(mesh, test::refined(test::box(4.1, 9.1), refinements));
    return mesh;
}

// Near the inner walls the nearest triangle does not tell the side, elsewhere it does.
TEST(InsideTestWithInnerWalls, AgreesWithTheWindingNumber)
{
    for (const int refinements : {1, 5})
    {
        const Surface surface(overlappingBoxes(refinements));
        ASSERT_TRUE(surface.anyTwoSided());
        const TriangleGrid grid(surface, GridFrame::cover(surface.box(), 0.8, 2), 1.1);
        const InsideTest inside(surface, grid);
        RandomPoints random(12);
        std::size_t within = 0;
        std::size_t nearWall = 0;
        std::size_t longLists = 0;
        for (int k = 0; k < 4000; ++k)
        {
            const Eigen::Vector3d p = random.point(-0.5, 9.6);
            const bool expected = windingNumber(surface.mesh(), p) > kInsideFrom;
            ASSERT_EQ(inside.contains(p), expected) << p.transpose();
            ASSERT_EQ(inside.distance(p) > 0, expected);
            within += expected ? 1 : 0;
            const auto triangles = grid.near(p);
            if (triangles.empty())
            {
                continue;
            }
            const SignedDistance nearest = grid.nearest(p, triangles);
            ASSERT_EQ(inside.contains(p, nearest), expected) << p.transpose();
            nearWall += (nearest.value > 0) != expected ? 1 : 0;
            longLists += triangles.size() > TriangleGrid::kShortList ? 1 : 0;
        }
        EXPECT_GT(within, 1000U);
        EXPECT_GT(nearWall, 50U);
        EXPECT_EQ(longLists > 1000, refinements > 1);
    }
}

// Those that lie in its leaf of the tree are not.
TEST(InsideTestWithInnerWalls, AgreesWithTheWindingNumberBesideASingleTwoSidedTriangle)
{
    const TriangleMesh mesh = test::refined(test::box(0, 6), 5);
    Walls walls = classifyWalls(mesh);
    std::vector<std::uint32_t> twoSided;
    for (std::uint32_t t = 7; t < mesh.triangles.size(); t += 1501)
    {
        walls.twoSided[t] = true;
        twoSided.push_back(t);
    }
    walls.count = twoSided.size();
    const Surface surface(mesh, walls);
    ASSERT_TRUE(surface.anyTwoSided());
    const TriangleGrid grid(surface, GridFrame::cover(surface.box(), 0.8, 2), 1.1);
    const InsideTest inside(surface, grid);
    RandomPoints random(3);
    std::size_t within = 0;
    for (const std::uint32_t t : twoSided)
    {
        const auto& [a, b, c] = surface[t].corner;
        ASSERT_GT(grid.near(a).size(), TriangleGrid::kShortList);
        for (int k = 0; k < 500; ++k)
        {
            const Eigen::Vector3d p = (a + b + c) / 3 + random.point(-0.2, 0.2);
            const bool expected = inside.isInsideByWinding(p);
            ASSERT_EQ(inside.contains(p), expected) << p.transpose();
            within += expected ? 1 : 0;
        }
    }
    EXPECT_GT(within, 200 * twoSided.size());
    EXPECT_LT(within, 300 * twoSided.size());
}

} // namespace
} // namespace frostfill

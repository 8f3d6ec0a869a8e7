// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "mesh/interior/inside_test.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr double kReach = 1.5;

TriangleMesh scaled(TriangleMesh mesh, double factor)
{
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex *= factor;
    }
    return mesh;
}

// A torus of some 30 cells across, and points about it, some beyond the grid.
class TriangleGridTest : public ::testing::Test
{
protected:
    Eigen::Vector3d point()
    {
        const Eigen::Vector3d half = 0.6 * surface.box().sizes();
        Eigen::Vector3d p;
        for (int axis = 0; axis < 3; ++axis)
        {
            p[axis] = half[axis] * (2 * uniformRandom(3, 0, draws++) - 1);
        }
        return surface.box().center() + p;
    }

    Surface surface{scaled(shapes::torus(), 12)};
    TriangleGrid grid{surface, GridFrame::cover(surface.box(), 1, 2), kReach};
    std::uint64_t draws = 0;
};

TEST_F(TriangleGridTest, ListsEveryTriangleWithinItsReach)
{
    std::size_t listed = 0;
    for (int k = 0; k < 2000; ++k)
    {
        const Eigen::Vector3d p = point();
        const auto near = grid.near(p);
        EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
        for (std::uint32_t t = 0; t < surface.size(); ++t)
        {
            const auto& [a, b, c] = surface[t].corner;
            if ((closestPointOnTriangle(p, a, b, c).point - p).norm() <= kReach)
            {
                EXPECT_TRUE(std::binary_search(near.begin(), near.end(), t)) << p.transpose();
                ++listed;
            }
        }
    }
    EXPECT_GT(listed, 1000u);
}

TEST_F(TriangleGridTest, InsideTestAgreesWithTheWindingNumber)
{
    const InsideTest inside(surface, grid);
    int within = 0;
    for (int k = 0; k < 5000; ++k)
    {
        const Eigen::Vector3d p = point();
        const bool expected = windingNumber(surface.mesh(), p) > 0.5;
        EXPECT_EQ(inside.contains(p), expected) << p.transpose();
        within += expected ? 1 : 0;
    }
    EXPECT_GT(within, 500);
}

} // namespace
} // namespace frostfill

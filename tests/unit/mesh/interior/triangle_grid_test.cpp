// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "mesh/interior/inside_test.hpp"
#include "support/shapes.hpp"
#include "support/winding_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

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

// By the distance of each triangle from the centre of each cell. Long lists may be cut short.
TEST_F(TriangleGridTest, ListsWhatMayBeNearACellAndNothingElse)
{
    const Surface dense(scaled(shapes::torus(1, 0.4, 96, 48), 3));
    for (const Surface* each : {&std::as_const(surface), &dense})
    {
        const TriangleGrid its(*each, GridFrame::cover(each->box(), 1, 2), kReach);
        const GridFrame& frame = its.frame();
        const double farthest = kReach + kHalfDiagonal * frame.cell;
        std::size_t cut = 0;
        for (std::size_t k = 0; k < frame.size(); k += 7)
        {
            const int x = static_cast<int>(k) % frame.count[0];
            const int y = static_cast<int>(k) / frame.count[0] % frame.count[1];
            const int z = static_cast<int>(k) / frame.count[0] / frame.count[1];
            const Eigen::Vector3d centre = frame.centre(x, y, z);
            std::vector<std::uint32_t> expected;
            for (std::uint32_t t = 0; t < each->size(); ++t)
            {
                const auto& [a, b, c] = (*each)[t].corner;
                const Eigen::Vector3d closest = closestPointOnTriangle(centre, a, b, c).point;
                if ((centre - closest).squaredNorm() <= farthest * farthest)
                {
                    expected.push_back(t);
                }
            }
            const auto listed = its.cell(x, y, z);
            const bool isLong = expected.size() > TriangleGrid::kShortList;
            EXPECT_TRUE(isLong || listed.size() <= TriangleGrid::kShortList);
            EXPECT_TRUE(
                std::includes(expected.begin(), expected.end(), listed.begin(), listed.end()));
            cut += isLong && listed.size() < expected.size() ? 1 : 0;
        }
        EXPECT_EQ(cut > 10, each == &dense) << cut;
    }
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

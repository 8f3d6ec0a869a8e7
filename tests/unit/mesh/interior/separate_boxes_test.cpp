// SPDX-License-Identifier: MIT
#include "mesh/interior/mesh_size.hpp"
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

TriangleMesh cubesAt(const std::vector<Eigen::Vector3d>& corners)
{
    TriangleMesh mesh;
    for (const Eigen::Vector3d& corner : corners)
    {
        test::append(mesh, shapes::box(corner, corner + Eigen::Vector3d::Ones()));
    }
    return mesh;
}

TEST(SeparateBoxes, AreThoseOfPartsThatLieApart)
{
    const auto boxes = separateBoxes(cubesAt({{100, 0, 0}, {0, 0, 0}, {0, 50, 0}}), 5);
    ASSERT_EQ(boxes.size(), 3u);
    EXPECT_EQ(boxes[2].min(), Eigen::Vector3d(100, 0, 0));
    EXPECT_EQ(boxes[2].max(), Eigen::Vector3d(101, 1, 1));
}

TEST(SeparateBoxes, HoldPiecesThatAreNearEachOther)
{
    EXPECT_EQ(separateBoxes(cubesAt({{0, 0, 0}, {3, 0, 0}}), 1.9).size(), 2u);
    EXPECT_EQ(separateBoxes(cubesAt({{0, 0, 0}, {3, 0, 0}}), 2.1).size(), 1u);
    // A chain: the first two are far apart until the others join them.
    EXPECT_EQ(
        separateBoxes(cubesAt({{0, 0, 0}, {0, 8, 0}, {0.5, 4, 0}, {0.7, 6, 0}, {0.6, 2, 0}}), 1.5)
            .size(),
        1u);
    TriangleMesh nested = shapes::box({0, 0, 0}, {10, 10, 10});
    test::append(nested, shapes::box({4, 4, 4}, {5, 5, 5}));
    EXPECT_EQ(separateBoxes(nested, 0).size(), 1u);
}

TEST(SeparateBoxes, OfNothingAreNone)
{
    EXPECT_TRUE(separateBoxes({}, 1).empty());
}

} // namespace
} // namespace frostfill

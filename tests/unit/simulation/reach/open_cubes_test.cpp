// SPDX-License-Identifier: MIT
#include "simulation/reach/open_cubes.hpp"

#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using reach::Object;
using reach::slantedTube;

constexpr std::size_t kMuch = std::size_t{1} << 30;

/// A box with a box-shaped hollow that is no part of its inside.
TriangleMesh hollowBox()
{
    TriangleMesh hollow = shapes::box({-9, -9, -9}, {9, 9, 9}, 2);
    for (auto& t : hollow.triangles)
    {
        std::swap(t[1], t[2]);
    }
    return reach::joined(shapes::box({-14, -14, -14}, {14, 14, 14}, 2), hollow);
}

std::optional<OpenCubes> openIn(const Object& object, double probe = 1, std::size_t bytes = kMuch)
{
    Threads two(2);
    return openCubesOf(object.surface, object.inside, probe, bytes, two);
}

/// Every cube of the grid against all triangles.
void expectExact(const Object& object, double probe)
{
    const std::optional<OpenCubes> empty = openIn(object, probe);
    ASSERT_TRUE(empty);
    const Cubes& cubes = empty->cubes;
    const double halfDiagonal = std::sqrt(0.75) * cubes.frame().cell;
    std::size_t open = 0;
    reach::forEachCubeOf(*empty,
                         [&](const GridPlace& place, bool isOpen)
                         {
                             const Eigen::Vector3d middle = cubes.middle(place);
                             const double depth = empty->exclusion(probe) - halfDiagonal -
                                                  distanceToSurface(object.surface, middle);
                             EXPECT_EQ(isOpen, depth < 0 && object.inside.contains(middle));
                             open += isOpen ? 1 : 0;
                         });
    EXPECT_GT(open, 10U);
}

TEST(OpenCubes, AreThoseInsideThatNoTriangleExcludesAsAWhole)
{
    for (const TriangleMesh& mesh :
         {reach::cubeOfSide(13.7), slantedTube(40, 6), shapes::torus(14, 3.2, 24, 8), hollowBox()})
    {
        expectExact(Object(mesh), 1);
    }
    expectExact(Object(reach::cubeOfSide(9)), 0.7);
}

// Walls lie at every place in a brick and in a word, and the grid ends at every one.
TEST(OpenCubes, AreTheSameWhereverBricksEnd)
{
    for (int k = 0; k < 24; ++k)
    {
        const Eigen::Vector3d size = {4 + 1.37 * k, 6 + 0.21 * k, 7 - 0.13 * k};
        expectExact(Object(shapes::box(Eigen::Vector3d::Zero(), size)), 1);
    }
}

TEST(OpenCubes, TakeMemoryByTheObjectNotByItsBox)
{
    // The box has room for 1e9 cubes, some 18,000,000 words.
    const Object object(slantedTube(2000, 6));
    const std::optional<OpenCubes> empty = openIn(object);
    ASSERT_TRUE(empty);
    EXPECT_LT(empty->cubes.words(), 300000U);
    std::size_t open = 0;
    for (const std::uint64_t word : empty->inside)
    {
        open += static_cast<std::size_t>(std::popcount(word));
    }
    EXPECT_GT(static_cast<double>(open) * std::pow(empty->cubes.frame().cell, 3), 2000 * 3.5 * 3.5);
}

TEST(OpenCubes, GrowWhereMemoryIsShortAndAreNoneBeforeTheyLeak)
{
    const Object object(reach::cubeOfSide(40));
    const std::optional<OpenCubes> fine = openIn(object);
    ASSERT_TRUE(fine);
    EXPECT_NEAR(fine->cubes.frame().cell, kReachVoxel, 1e-12);
    const std::size_t less = 8 * fine->cubes.words() - 8;
    const std::optional<OpenCubes> coarse = openIn(object, 1, less);
    ASSERT_TRUE(coarse);
    EXPECT_GT(coarse->cubes.frame().cell, kReachVoxel);
    EXPECT_LE(coarse->cubes.words() * 8, less);
    EXPECT_FALSE(openIn(object, 1, 1000));
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "unit/simulation/reach/reach_scene.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// Boxes of 8 x 8 x 8 and 6 x 6 x 6 with a passage of the given width, 6 long, along x.
TriangleMesh dumbbell(int width)
{
    std::set<std::array<int, 3>> cells;
    reach::addBlock(cells, {0, 0, 0}, {8, 8, 8});
    reach::addBlock(cells, {8, 3, 3}, {14, 3 + width, 3 + width});
    reach::addBlock(cells, {14, 1, 1}, {20, 7, 7});
    return reach::cubes(cells);
}

// A part of less than one sphere is a crumb: the sphere here has the volume 4.2, and the neck 6.
TEST(ReachInspection, OnlyAPartThatIsItselfTooNarrowIsUnreachable)
{
    std::set<std::array<int, 3>> cells;
    reach::addBlock(cells, {0, 0, 0}, {8, 8, 8});
    reach::addBlock(cells, {8, 3, 3}, {28, 4, 4});
    reach::addBlock(cells, {28, 1, 1}, {34, 7, 7});
    const ReachInspection found = inspectReach(reach::cubes(cells), 1);
    ASSERT_TRUE(found.known && found.fits);
    ASSERT_EQ(found.parts.size(), 1U);
    EXPECT_GT(found.parts[0].volume, 5) << "of cubes whose middle is inside";
    EXPECT_LT(found.parts[0].volume, 20);
    EXPECT_GE(found.unreachable, found.parts[0].volume);
    EXPECT_NEAR(found.parts[0].centre.x(), 18, 0.5);
    EXPECT_NEAR(found.parts[0].centre.y(), 3.5, 0.3);
    EXPECT_NEAR(found.parts[0].box.sizes().x(), 20 - 2, 1.5);
    EXPECT_TRUE(inspectReach(dumbbell(1), 1).parts.empty()) << "a crumb";
}

TEST(ReachInspection, AWidePassageLeavesNothingUnreachable)
{
    EXPECT_TRUE(inspectReach(dumbbell(3), 1).parts.empty());
}

TEST(ReachInspection, PartsComeLargestFirst)
{
    std::set<std::array<int, 3>> cells;
    reach::addBlock(cells, {0, 0, 0}, {8, 8, 8});
    reach::addBlock(cells, {8, 4, 4}, {18, 5, 5});
    reach::addBlock(cells, {-14, 4, 4}, {0, 5, 5});
    const ReachInspection found = inspectReach(reach::cubes(cells), 1);
    ASSERT_EQ(found.parts.size(), 2U);
    EXPECT_LT(found.parts[0].centre.x(), 0);
    EXPECT_GT(found.parts[1].centre.x(), 8);
    EXPECT_GT(found.parts[0].volume, found.parts[1].volume);
}

// Two walls each exclude half of the cubes between them.
TEST(ReachInspection, NothingFitsBetweenWallsThatAreTooClose)
{
    EXPECT_FALSE(inspectReach(shapes::box({0, 0, 0}, {20, 1.6, 20}), 1).fits);
    EXPECT_TRUE(inspectReach(shapes::box({0, 0, 0}, {20, 2.1, 20}), 1).fits);
}

TEST(ReachInspection, ALongObjectIsInspectedBeforeItIsFilled)
{
    // 120 cubes of a radius across, in a box of 3e9.
    const ReachInspection tube = inspectReach(reach::slantedTube(2400, 6), 1);
    EXPECT_TRUE(tube.known);
    EXPECT_TRUE(tube.fits);
    EXPECT_TRUE(tube.parts.empty());
    const ReachInspection narrow = inspectReach(reach::slantedTube(2400, 1.5), 1);
    EXPECT_TRUE(narrow.known);
    EXPECT_FALSE(narrow.fits);
    EXPECT_FALSE(inspectReach(reach::slantedTube(2400, 6), 1e-4).known) << "too many cells";
}

} // namespace
} // namespace frostfill

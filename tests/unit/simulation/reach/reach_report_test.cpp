// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_report.hpp"

#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using reach::Object;
using reach::withHole;

constexpr double kSphereVolume = 4.18879;

TriangleMesh cubeOfQuads()
{
    return shapes::box(Eigen::Vector3d::Constant(-6), Eigen::Vector3d::Constant(6), 12);
}

/// Boxes of 8 x 8 x 8 and 6 x 6 x 6 with a passage of the given width, 6 long, along x.
TriangleMesh dumbbell(int width)
{
    std::set<std::array<int, 3>> cells;
    reach::addBlock(cells, {0, 0, 0}, {8, 8, 8});
    reach::addBlock(cells, {8, 3, 3}, {14, 3 + width, 3 + width});
    reach::addBlock(cells, {14, 1, 1}, {20, 7, 7});
    return reach::cubes(cells);
}

TEST(ReachReport, ClosedSurfaceDoesNotLeak)
{
    const Object cube(cubeOfQuads());
    EXPECT_FALSE(ReachMap(cube.surface, cube.inside, {1, 1}, {}).leak().has_value());
    const Object torus(shapes::torus(8, 3, 32, 12));
    EXPECT_FALSE(ReachMap(torus.surface, torus.inside, {1, 1}, {}).leak().has_value());
    const Object bells(dumbbell(1));
    EXPECT_FALSE(ReachMap(bells.surface, bells.inside, {1, 1}, {}).leak().has_value());
}

TEST(ReachReport, HoleNarrowerThanTheSphereDoesNotLeak)
{
    const Object object(withHole(cubeOfQuads(), {0.5, 6, 0.5}, 1));
    ASSERT_EQ(object.surface.size(), 12u * 144 - 2);
    const ReachMap map(object.surface, object.inside, {1, 1}, {});
    EXPECT_TRUE(map.active());
    EXPECT_FALSE(map.leak().has_value());
}

TEST(ReachReport, HoleWiderThanTheSphereIsFoundWhereItIs)
{
    for (const Eigen::Vector3d& where :
         {Eigen::Vector3d(2, 6, -1), Eigen::Vector3d(-6, 1, 1), Eigen::Vector3d(0, -6, 0)})
    {
        const Object object(withHole(cubeOfQuads(), where, 4));
        const ReachMap map(object.surface, object.inside, {1, 1}, {});
        EXPECT_FALSE(map.active());
        ASSERT_TRUE(map.leak().has_value());
        EXPECT_LT((*map.leak() - where).lpNorm<Eigen::Infinity>(), 2.5);
    }
}

TEST(ReachReport, BoxBehindANarrowNeckIsUnreachableFromTheOther)
{
    const Object object(dumbbell(1));
    ReachMap::Unblocked unblocked;
    ReachMap map(object.surface, object.inside, {1, 1}, {}, {}, &unblocked);
    map.withdrawSeeds();
    const std::vector<Eigen::Vector3d> running = {{4, 4, 4}};
    ASSERT_TRUE(map.flood(running));
    Threads threads(2);
    const ReachReport report = reportReach(map, unblocked, object.inside, kSphereVolume, threads);
    ASSERT_EQ(report.parts.size(), 1u);
    EXPECT_GE(report.unreachedVolume, report.parts[0].volume);
    EXPECT_LT(report.unreachedVolume, 216 + 6 + 0.02 * 512) << "edges are narrow, too";
    // The neck is 6 long; spheres reach into it by less than a radius and two cubes.
    EXPECT_GT(report.parts[0].volume, 216 + 6 - 2 - 1);
    EXPECT_LT(report.parts[0].volume, 216 + 6);
    EXPECT_NEAR(report.parts[0].centre.x(), 16.8, 0.3);
    EXPECT_NEAR(report.parts[0].box.max().x(), 20, 0.5);
    EXPECT_NEAR(report.parts[0].box.min().x(), 8 + 1, 1);
    EXPECT_NEAR(report.parts[0].box.max().y(), 7, 0.5);
}

TEST(ReachReport, OnlyTheNeckIsUnreachableFromEverywhere)
{
    const Object object(dumbbell(1));
    ReachMap::Unblocked unblocked;
    ReachMap map(object.surface, object.inside, {1, 1}, {}, {}, &unblocked);
    ASSERT_TRUE(map.flood({}));
    Threads threads(2);
    const ReachReport report = reportReach(map, unblocked, object.inside, 1, threads);
    ASSERT_EQ(report.parts.size(), 1u);
    EXPECT_GT(report.parts[0].volume, 6 - 2 * 2);
    EXPECT_LT(report.parts[0].volume, 6);
    EXPECT_NEAR(report.parts[0].centre.x(), 11, 0.5);
    EXPECT_NEAR(report.parts[0].centre.y(), 3.5, 0.3);
    EXPECT_TRUE(reportReach(map, unblocked, object.inside, 6, threads).parts.empty()) << "a crumb";

    // No sphere ever touches the neck's middle triangles.
    const auto isMiddle = [&](std::uint32_t t)
    {
        const auto& corner = object.surface[t].corner;
        return std::all_of(corner.begin(), corner.end(),
                           [](const auto& c) { return c.x() > 10.5 && c.x() < 12.5; });
    };
    for (std::uint32_t t = 0; t < object.surface.size(); ++t)
    {
        EXPECT_TRUE(map.polygonDroppable(t) || !isMiddle(t));
    }
}

TEST(ReachReport, WidePassageLeavesNothingUnreachable)
{
    const Object object(dumbbell(3));
    ReachMap::Unblocked unblocked;
    ReachMap map(object.surface, object.inside, {1, 1}, {}, {}, &unblocked);
    map.withdrawSeeds();
    const std::vector<Eigen::Vector3d> running = {{4, 4, 4}};
    ASSERT_TRUE(map.flood(running));
    EXPECT_TRUE(map.contains({18, 4, 4}));
    Threads threads(2);
    EXPECT_TRUE(reportReach(map, unblocked, object.inside, 1, threads).parts.empty());
}

TEST(ReachReport, PartsComeLargestFirst)
{
    std::set<std::array<int, 3>> cells;
    reach::addBlock(cells, {0, 0, 0}, {8, 8, 8});
    reach::addBlock(cells, {8, 4, 4}, {16, 5, 5});
    reach::addBlock(cells, {-14, 4, 4}, {0, 5, 5});
    const Object object(reach::cubes(cells));
    ReachMap::Unblocked unblocked;
    ReachMap map(object.surface, object.inside, {1, 1}, {}, {}, &unblocked);
    ASSERT_TRUE(map.flood({}));
    Threads threads(2);
    const ReachReport report = reportReach(map, unblocked, object.inside, 1, threads);
    ASSERT_EQ(report.parts.size(), 2u);
    EXPECT_LT(report.parts[0].centre.x(), 0);
    EXPECT_GT(report.parts[1].centre.x(), 8);
    EXPECT_GT(report.parts[0].volume, report.parts[1].volume);
}

} // namespace
} // namespace frostfill

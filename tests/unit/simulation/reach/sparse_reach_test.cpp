// SPDX-License-Identifier: MIT
#include "simulation/reach/reach_report.hpp"
#include "unit/simulation/reach/reach_scene.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// The map in bricks, as large boxes have it, against the whole grid and against brute force.
namespace frostfill
{
namespace
{

using reach::joined;
using reach::Object;
using reach::Random;
using reach::slantedTube;
using reach::twoBoxesFarApart;
using reach::withHole;

constexpr std::size_t kMuch = std::size_t{1} << 30;
constexpr ReachMap::Margins kMargins;
constexpr ReachMap::Resolution kWhole = {0.5, kMuch, kMuch};
constexpr ReachMap::Resolution kBricks = {0.5, kMuch, 0};

/// A box with a box-shaped hollow that is no part of its inside.
TriangleMesh hollowBox()
{
    TriangleMesh hollow = shapes::box({-9, -9, -9}, {9, 9, 9}, 2);
    for (auto& t : hollow.triangles)
    {
        std::swap(t[1], t[2]);
    }
    return joined(shapes::box({-14, -14, -14}, {14, 14, 14}, 2), hollow);
}

std::vector<TriangleMesh> objects()
{
    return {reach::cubeOfSide(13.7), slantedTube(90, 6), twoBoxesFarApart(),
            shapes::torus(24, 3.2, 48, 12), hollowBox()};
}

Eigen::Vector3d pointIn(const Object& object, Random& random)
{
    const Eigen::AlignedBox3d box = object.surface.box();
    while (true)
    {
        const Eigen::Vector3d share = random.point(0, 1);
        Eigen::Vector3d p = box.min() + share.cwiseProduct(box.sizes());
        if (object.inside.contains(p))
        {
            return p;
        }
    }
}

std::vector<Eigen::Vector3d> reachedMiddles(const ReachMap& map)
{
    std::vector<Eigen::Vector3d> result;
    reach::forEachCubeOf(map,
                         [&](int x, int y, int z, bool isReached)
                         {
                             if (isReached)
                             {
                                 result.push_back(map.layout().frame.centre(x, y, z));
                             }
                         });
    return result;
}

std::vector<Eigen::Vector3d> reachedOf(const ReachMap& map,
                                       const std::vector<Eigen::Vector3d>& points)
{
    std::vector<Eigen::Vector3d> result;
    std::copy_if(points.begin(), points.end(), std::back_inserter(result),
                 [&](const Eigen::Vector3d& p) { return map.contains(p); });
    return result;
}

/// Two maps of an object to which the same happens.
struct Pair
{
    Pair(const Object& object, const ReachMap::Radii& radii)
        : whole(object.surface, object.inside, radii, kMargins, kWhole, &ofWhole),
          bricks(object.surface, object.inside, radii, kMargins, kBricks, &ofBricks)
    {
        EXPECT_TRUE(whole.layout().isWhole());
        EXPECT_FALSE(bricks.layout().isWhole());
        EXPECT_TRUE(whole.active());
        EXPECT_TRUE(bricks.active());
    }
    void expectTheSame()
    {
        ASSERT_EQ(reachedMiddles(bricks), reachedMiddles(whole));
        ASSERT_EQ(bricks.reachedCount(), whole.reachedCount());
    }

    ReachMap::Unblocked ofWhole;
    ReachMap::Unblocked ofBricks;
    ReachMap whole;
    ReachMap bricks;
};

TEST(SparseReach, HoldsTheSameCubesAsTheWholeGridWhateverComesToRest)
{
    std::size_t dropped = 0;
    for (const TriangleMesh& mesh : objects())
    {
        Random random(mesh.vertices.size());
        const Object object(mesh);
        Pair maps(object, {0.9, 1});
        maps.expectTheSame();
        ASSERT_GT(maps.whole.reachedCount(), 100u);
        ASSERT_TRUE(maps.whole.flood({}) && maps.bricks.flood({}));
        std::vector<ReachMap::Cursor> cursors;
        std::vector<Eigen::Vector3d> balls;
        for (int round = 0; round < 8; ++round)
        {
            for (int k = 0; k < 25; ++k)
            {
                balls.push_back(pointIn(object, random));
                cursors.push_back(0);
                maps.whole.addResting(balls.back(), 1);
                maps.bricks.addResting(balls.back(), 1);
            }
            if (round == 5)
            {
                maps.whole.withdrawSeeds();
                maps.bricks.withdrawSeeds();
            }
            const auto running =
                reachedOf(maps.whole, {pointIn(object, random), pointIn(object, random)});
            ASSERT_TRUE(maps.whole.update(running) && maps.bricks.update(running));
            maps.expectTheSame();
            for (std::size_t k = 0; k < balls.size(); ++k)
            {
                const bool droppable = maps.whole.sphereDroppable(balls[k], 1);
                ASSERT_EQ(maps.bricks.sphereDroppable(balls[k], 1, cursors[k],
                                                      [](int, int, int) { return true; }),
                          droppable);
                dropped += droppable ? 1 : 0;
            }
            for (std::uint32_t t = 0; t < object.surface.size(); ++t)
            {
                ASSERT_EQ(maps.bricks.polygonDroppable(t), maps.whole.polygonDroppable(t));
            }
        }
    }
    EXPECT_GT(dropped, 100u);
}

/// Cubes that are connected with the running centres, by a plain search over the whole box.
std::vector<Eigen::Vector3d> reachedByBruteForce(const ReachMap& map, const Object& object,
                                                 const std::vector<Eigen::Vector3d>& balls,
                                                 const std::vector<Eigen::Vector3d>& running)
{
    const GridFrame& frame = map.layout().frame;
    const double diagonal = std::sqrt(3.0) * frame.cell;
    std::vector<char> open(frame.size());
    const auto isOpen = [&](const Eigen::Vector3d& middle)
    {
        const auto excludes = [&](const Eigen::Vector3d& ball)
        {
            const Eigen::Array3d corner = (middle - ball).cwiseAbs().array() + frame.cell / 2;
            return corner.matrix().norm() <= map.exclusion(2);
        };
        return object.inside.contains(middle) &&
               distanceToSurface(object.surface, middle) > map.exclusion(1) - diagonal / 2 &&
               std::none_of(balls.begin(), balls.end(), excludes);
    };
    std::vector<std::array<int, 3>> waiting;
    waiting.reserve(running.size());
    for (const Eigen::Vector3d& p : running)
    {
        waiting.push_back(frame.coordinates(p));
    }
    while (!waiting.empty())
    {
        const auto [x, y, z] = waiting.back();
        waiting.pop_back();
        char& state = open[frame.index(x, y, z)];
        if (state != 0)
        {
            continue;
        }
        state = isOpen(frame.centre(x, y, z)) ? 2 : 1;
        for (int face = 0; state == 2 && face < 6; ++face)
        {
            std::array<int, 3> next = {x, y, z};
            next[face / 2] += face % 2 == 0 ? -1 : 1;
            waiting.push_back(next); // what is open is away from the border
        }
    }
    std::vector<Eigen::Vector3d> result;
    reach::forEachCubeOf(map,
                         [&](int x, int y, int z, bool)
                         {
                             if (open[frame.index(x, y, z)] == 2)
                             {
                                 result.push_back(frame.centre(x, y, z));
                             }
                         });
    return result;
}

TEST(SparseReach, EqualsAPlainSearchOfTheWholeBox)
{
    for (const TriangleMesh& mesh : objects())
    {
        Random random(mesh.triangles.size());
        const Object object(mesh);
        ReachMap map(object.surface, object.inside, {1, 1}, kMargins, kBricks);
        std::vector<Eigen::Vector3d> balls;
        for (int k = 0; k < 60; ++k)
        {
            balls.push_back(pointIn(object, random));
            map.addResting(balls.back(), 1);
        }
        map.withdrawSeeds();
        std::vector<Eigen::Vector3d> running;
        for (int k = 0; k < 1000 && running.size() < 2; ++k)
        {
            running = reachedOf(map, {pointIn(object, random), pointIn(object, random)});
        }
        ASSERT_TRUE(map.flood(running));
        EXPECT_EQ(reachedMiddles(map), reachedByBruteForce(map, object, balls, running));
        EXPECT_GT(map.reachedCount(), 10u);
    }
}

// Walls lie at every place in a brick and in a word, and the grid ends at every one.
TEST(SparseReach, HoldsTheSameCubesWhereverBricksEnd)
{
    for (int k = 0; k < 24; ++k)
    {
        const Eigen::Vector3d size = {4 + 1.37 * k, 6 + 0.21 * k, 7 - 0.13 * k};
        const Object object(shapes::box(Eigen::Vector3d::Zero(), size));
        Pair maps(object, {1, 1});
        maps.expectTheSame();
        ASSERT_GT(maps.whole.reachedCount(), 10u);
        const std::vector<Eigen::Vector3d> balls = {size / 2, size / 3};
        for (const Eigen::Vector3d& ball : balls)
        {
            maps.whole.addResting(ball, 1);
            maps.bricks.addResting(ball, 1);
        }
        ASSERT_TRUE(maps.whole.flood({}) && maps.bricks.flood({}));
        maps.expectTheSame();
    }
}

TEST(SparseReach, ASphereRestingInOneInteriorLeavesTheOtherAlone)
{
    const Object object(twoBoxesFarApart());
    ReachMap map(object.surface, object.inside, {1, 1}, kMargins, kBricks);
    map.withdrawSeeds();
    ASSERT_TRUE(map.flood(std::vector<Eigen::Vector3d>{{4, 4, 4}}));
    EXPECT_TRUE(map.contains({5, 3, 4}));
    EXPECT_FALSE(map.contains({153, 65, -65}));
    EXPECT_FALSE(map.contains({80, 30, -30})) << "between them";
    EXPECT_TRUE(map.sphereDroppable({153, 65, -65}, 1));
    EXPECT_FALSE(map.sphereDroppable({4, 4, 4}, 1));
    EXPECT_TRUE(map.sphereDroppable({80, 30, -30}, 1));
    EXPECT_FALSE(map.reaches({80, 30, -30}, 3));
}

TEST(SparseReach, MemoryFollowsTheObjectNotItsBox)
{
    // The box has room for 2e9 cubes, some 30,000,000 words.
    const Object object(slantedTube(2000, 6));
    const ReachMap map(object.surface, object.inside, {1, 1}, kMargins);
    ASSERT_TRUE(map.active());
    EXPECT_LT(map.layout().words, 300000u);
    EXPECT_TRUE(map.contains({0, 0, 0}));
    const double cell = map.layout().frame.cell;
    EXPECT_GT(static_cast<double>(map.reachedCount()) * cell * cell * cell, 2000 * 3.5 * 3.5);
    ReachMap none(object.surface, object.inside, {1, 1}, kMargins, {0.5, 1u << 20});
    EXPECT_FALSE(none.active()) << "which would take 10 MB";
}

TEST(SparseReach, FindsTheHoleThatTheWholeGridFinds)
{
    const TriangleMesh cube =
        shapes::box(Eigen::Vector3d::Constant(-8), Eigen::Vector3d::Constant(8), 16);
    for (const Eigen::Vector3d& where :
         {Eigen::Vector3d(2, 8, -1), Eigen::Vector3d(-8, 1, 1), Eigen::Vector3d(0, 0, 8)})
    {
        const Object object(withHole(cube, where, 4));
        const ReachMap whole(object.surface, object.inside, {1, 1}, kMargins, kWhole);
        const ReachMap bricks(object.surface, object.inside, {1, 1}, kMargins, kBricks);
        EXPECT_FALSE(bricks.active());
        ASSERT_TRUE(whole.leak() && bricks.leak());
        EXPECT_LT((*bricks.leak() - where).lpNorm<Eigen::Infinity>(), 2.5);
        EXPECT_LT((*bricks.leak() - *whole.leak()).lpNorm<Eigen::Infinity>(), 1.5);
    }
    const Object narrow(withHole(cube, {0.5, 8, 0.5}, 1));
    EXPECT_TRUE(ReachMap(narrow.surface, narrow.inside, {1, 1}, kMargins, kBricks).active());
}

TEST(SparseReach, ReportsTheSamePartsAsTheWholeGrid)
{
    std::set<std::array<int, 3>> cells;
    reach::addBlock(cells, {0, 0, 0}, {8, 8, 8});
    reach::addBlock(cells, {8, 3, 3}, {88, 4, 4}); // too narrow
    reach::addBlock(cells, {88, 1, 1}, {94, 7, 7});
    const Object object(reach::cubes(cells));
    Pair maps(object, {1, 1});
    ASSERT_TRUE(maps.whole.flood({}) && maps.bricks.flood({}));
    Threads threads(3);
    const ReachReport whole = reportReach(maps.whole, maps.ofWhole, object.inside, 1, threads);
    const ReachReport bricks = reportReach(maps.bricks, maps.ofBricks, object.inside, 1, threads);
    EXPECT_GT(whole.unreachedVolume, 60);
    EXPECT_EQ(bricks.unreachedVolume, whole.unreachedVolume);
    EXPECT_EQ(bricks.resolution, whole.resolution);
    ASSERT_EQ(bricks.parts.size(), whole.parts.size());
    ASSERT_EQ(bricks.parts.size(), 1u);
    EXPECT_EQ(bricks.parts[0].volume, whole.parts[0].volume);
    EXPECT_LT((bricks.parts[0].centre - whole.parts[0].centre).norm(), 1e-9);
    EXPECT_TRUE(bricks.parts[0].box.isApprox(whole.parts[0].box));
}

TEST(SparseReach, ALongObjectIsInspectedBeforeItIsFilled)
{
    // 120 cubes of a radius across, in a box of 3e9.
    const ReachInspection tube = inspectReach(slantedTube(2400, 6), 1);
    EXPECT_TRUE(tube.known);
    EXPECT_TRUE(tube.fits);
    EXPECT_FALSE(tube.leak.has_value());
    EXPECT_TRUE(tube.parts.empty());
    const ReachInspection narrow = inspectReach(slantedTube(2400, 1.5), 1);
    EXPECT_TRUE(narrow.known);
    EXPECT_FALSE(narrow.fits);
    EXPECT_FALSE(inspectReach(slantedTube(2400, 6), 1e-4).known) << "too many cells of a radius";
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using reach::Ball;
using reach::cubeOfSide;
using reach::Object;
using reach::Random;

constexpr ReachMap::Margins kWide = {0.1, 1.0, 0.3};

double jumpRadius(double contact, const ReachMap::Margins& m)
{
    return std::sqrt((contact - m.overlap) * (contact - m.overlap) - m.step * m.step / 4);
}

double farthestCorner(const Eigen::Vector3d& middle, double edge, const Eigen::Vector3d& p)
{
    return ((middle - p).cwiseAbs().array() + edge / 2).matrix().norm();
}

double nearestCorner(const Eigen::Vector3d& middle, double edge, const Eigen::Vector3d& p)
{
    return ((middle - p).cwiseAbs().array() - edge / 2).max(0).matrix().norm();
}

/// Whether a sphere may be at p under guard G1.
bool isValid(const Object& object, const std::vector<Ball>& resting, double radius,
             const ReachMap::Margins& m, const Eigen::Vector3d& p)
{
    if (!object.inside.contains(p) || distanceToSurface(object.surface, p) < radius - m.overlap)
    {
        return false;
    }
    for (const Ball& ball : resting)
    {
        if ((ball.centre - p).norm() < ball.radius + radius - m.overlap)
        {
            return false;
        }
    }
    return true;
}

std::vector<Ball> randomSequentialInsertion(const Object& object, std::size_t attempts,
                                            const ReachMap::Radii& radii,
                                            const ReachMap::Margins& m, Random& random)
{
    std::vector<Ball> balls;
    const double half = object.surface.box().sizes().maxCoeff() / 2;
    for (std::size_t i = 0; i < attempts; ++i)
    {
        const Eigen::Vector3d p = random.point(-half, half);
        const double radius = random.uniform(radii.smallest, radii.largest);
        if (isValid(object, balls, radius, m, p))
        {
            balls.push_back({p, radius});
        }
    }
    return balls;
}

TEST(ReachMap, CubeIsBlockedExactlyWhenOneObstacleExcludesAllOfIt)
{
    for (const ReachMap::Radii radii : {ReachMap::Radii{1, 1}, ReachMap::Radii{0.8, 1}})
    {
        Random random(3);
        const Object object(cubeOfSide(9.3));
        const auto balls = randomSequentialInsertion(object, 300, radii, kWide, random);
        ReachMap map(object.surface, object.inside, radii, kWide);
        ASSERT_TRUE(map.active());
        for (const Ball& ball : balls)
        {
            map.addResting(ball.centre, ball.radius);
        }
        const double h = map.layout().frame.cell;
        std::size_t blocked = 0;
        reach::forEachCubeOf(
            map,
            [&](int x, int y, int z, bool open)
            {
                const Eigen::Vector3d middle = map.layout().frame.centre(x, y, z);
                if (!object.inside.contains(middle))
                {
                    EXPECT_FALSE(open);
                    return;
                }
                // How deep the cube lies in the exclusion that holds it best.
                double depth = jumpRadius(radii.smallest, kWide) -
                               distanceToSurface(object.surface, middle) - std::sqrt(0.75) * h;
                for (const Ball& ball : balls)
                {
                    depth = std::max(depth, jumpRadius(ball.radius + radii.smallest, kWide) -
                                                farthestCorner(middle, h, ball.centre));
                }
                EXPECT_EQ(open, depth < 0) << depth;
                blocked += open ? 0 : 1;
            });
        EXPECT_GT(blocked, 1000u);
    }
}

TEST(ReachMap, JumpsThatKeepTheGuardsNeverLeaveTheReachedSet)
{
    for (std::uint64_t seed = 0; seed < 6; ++seed)
    {
        Random random(seed);
        const ReachMap::Radii radii{seed % 2 == 0 ? 1.0 : 0.8, 1};
        const Object object(cubeOfSide(11));
        auto resting = randomSequentialInsertion(object, 400, radii, kWide, random);
        ReachMap map(object.surface, object.inside, radii, kWide);
        for (const Ball& ball : resting)
        {
            map.addResting(ball.centre, ball.radius);
        }
        std::vector<Ball> running;
        while (running.size() < 3)
        {
            const Ball ball{random.point(-5, 5), radii.smallest};
            if (isValid(object, resting, ball.radius, kWide, ball.centre))
            {
                running.push_back(ball);
            }
        }
        const auto centres = [&]
        {
            std::vector<Eigen::Vector3d> result;
            result.reserve(running.size());
            for (const Ball& ball : running)
            {
                result.push_back(ball.centre);
            }
            return result;
        };
        map.withdrawSeeds();
        ASSERT_TRUE(map.flood(centres()));
        std::size_t moves = 0;
        for (int step = 0; step < 6000; ++step)
        {
            Ball& ball = running[static_cast<std::size_t>(step) % running.size()];
            const Eigen::Vector3d p = ball.centre + random.direction(kWide.step);
            if (isValid(object, resting, ball.radius, kWide, p))
            {
                ball.centre = p;
                ++moves;
                ASSERT_TRUE(map.contains(p)) << step;
            }
            if (step % 600 == 599)
            {
                // One more comes to rest, clear of those that run.
                const Eigen::Vector3d q = random.point(-5, 5);
                auto others = resting;
                others.insert(others.end(), running.begin(), running.end());
                if (isValid(object, others, radii.smallest, kWide, q))
                {
                    resting.push_back({q, radii.smallest});
                    map.addResting(q, radii.smallest);
                }
                ASSERT_TRUE(map.update(centres()));
            }
            // Nothing that a contact query may find is ever droppable.
            const Eigen::Vector3d query = ball.centre + random.direction(kWide.query);
            for (const Ball& obstacle : resting)
            {
                if ((obstacle.centre - query).norm() < obstacle.radius + ball.radius)
                {
                    ASSERT_FALSE(map.sphereDroppable(obstacle.centre, obstacle.radius));
                }
            }
        }
        EXPECT_GT(moves, 300u);
    }
}

TEST(ReachMap, JumpThroughAGateTooNarrowToPassIsFollowed)
{
    // The middle of four spheres is too near to them to be in, but both sides of it are not: one
    // step of length D leads through. Cubes are small, so that nothing but the rule keeps it open.
    const Object object(cubeOfSide(4));
    const double toMiddle =
        std::sqrt((2 - kWide.overlap) * (2 - kWide.overlap) - kWide.step * kWide.step / 4 + 1e-3);
    const double apart = toMiddle / std::sqrt(2.0);
    for (const double step : {kWide.step, 0.8 * kWide.step})
    {
        const ReachMap::Margins margins{kWide.overlap, step, kWide.query};
        ReachMap map(object.surface, object.inside, {1, 1}, margins, {0.06, 1u << 30});
        for (const double x : {-apart, apart})
        {
            map.addResting({x, 0, apart}, 1);
            map.addResting({x, 0, -apart}, 1);
        }
        map.withdrawSeeds();
        const std::vector<Eigen::Vector3d> running = {{0, step / 2, 0}};
        ASSERT_TRUE(map.flood(running));
        EXPECT_EQ(map.contains({0, -step / 2, 0}), step == kWide.step);
    }
}

TEST(ReachMap, DroppableEqualsBruteForceOverAllReachedCubes)
{
    Random random(5);
    const Object object(shapes::torus(5.5, 2.4, 24, 10));
    const ReachMap::Radii radii{0.8, 1};
    ReachMap map(object.surface, object.inside, radii, kWide);
    const double h = map.layout().frame.cell;
    map.withdrawSeeds();
    const std::vector<Eigen::Vector3d> running = {{0, 6.3, 0}}; // above all that comes to rest
    ASSERT_TRUE(map.flood(running));
    std::vector<ReachMap::Cursor> cursors;
    std::vector<Ball> balls;
    std::size_t droppedSpheres = 0;
    std::size_t droppedPolygons = 0;
    for (int round = 0; round < 5; ++round)
    {
        for (int i = 0; i < 130; ++i)
        {
            // From the bottom up, so that something gets buried.
            Eigen::Vector3d p = random.point(-8, 8);
            p.y() = random.uniform(-8, -8 + 2.4 * (round + 1));
            const Ball ball{p, random.uniform(0.8, 1)};
            balls.push_back(ball);
            cursors.push_back(0);
            map.addResting(ball.centre, ball.radius);
        }
        ASSERT_TRUE(map.update(running));
        std::vector<Eigen::Vector3d> reached;
        reach::forEachCubeOf(map,
                             [&](int x, int y, int z, bool isReached)
                             {
                                 if (isReached)
                                 {
                                     reached.push_back(map.layout().frame.centre(x, y, z));
                                 }
                             });
        for (std::size_t i = 0; i < balls.size(); ++i)
        {
            const double limit = balls[i].radius + radii.largest + kWide.query;
            const bool droppable =
                std::none_of(reached.begin(), reached.end(),
                             [&](const Eigen::Vector3d& middle)
                             { return nearestCorner(middle, h, balls[i].centre) <= limit; });
            EXPECT_EQ(map.sphereDroppable(balls[i].centre, balls[i].radius), droppable);
            EXPECT_EQ(map.sphereDroppable(balls[i].centre, balls[i].radius, cursors[i],
                                          [](int, int, int) { return true; }),
                      droppable);
            droppedSpheres += droppable ? 1 : 0;
        }
        for (std::uint32_t t = 0; t < object.surface.size(); ++t)
        {
            const auto& corner = object.surface[t].corner;
            const double limit = radii.largest + kWide.query + std::sqrt(0.75) * h;
            const bool droppable = std::none_of(reached.begin(), reached.end(),
                                                [&](const Eigen::Vector3d& middle)
                                                {
                                                    const auto closest = closestPointOnTriangle(
                                                        middle, corner[0], corner[1], corner[2]);
                                                    return (closest.point - middle).norm() <= limit;
                                                });
            EXPECT_EQ(map.polygonDroppable(t), droppable);
            droppedPolygons += droppable ? 1 : 0;
        }
    }
    EXPECT_GT(droppedSpheres, 50u);
    EXPECT_GT(droppedPolygons, 20u);
    EXPECT_GT(map.reachedCount(), 0u);
}

TEST(ReachMap, CubesGrowUnderAMemoryLimitAndTheMapGivesUpBeforeItLeaks)
{
    const Object object(cubeOfSide(40));
    const ReachMap::Margins margins;
    const ReachMap fine(object.surface, object.inside, {1, 1}, margins, {0.3, 1u << 30});
    EXPECT_NEAR(fine.layout().frame.cell, 0.3, 1e-12);
    const ReachMap coarse(object.surface, object.inside, {1, 1}, margins, {0.3, 900000});
    EXPECT_TRUE(coarse.active());
    EXPECT_GT(coarse.layout().frame.cell, 0.3);
    EXPECT_LE(coarse.layout().words * 32, 900000u);
    ReachMap none(object.surface, object.inside, {1, 1}, margins, {0.3, 1000});
    EXPECT_FALSE(none.active());
    EXPECT_TRUE(none.flood({}));
    EXPECT_TRUE(none.contains({0, 0, 0}));
    EXPECT_FALSE(none.sphereDroppable({0, 0, 0}, 1));
    EXPECT_FALSE(none.polygonDroppable(0));
}

TEST(ReachMap, MarginsThatLeaveNoExclusionMakeItInactive)
{
    const Object object(cubeOfSide(12));
    const ReachMap map(object.surface, object.inside, {1, 1}, {0.5, 1.2, 0.3});
    EXPECT_FALSE(map.active());
}

} // namespace
} // namespace frostfill

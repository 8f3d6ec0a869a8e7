// SPDX-License-Identifier: MIT
#include "simulation/contact/sphere_cast.hpp"

#include "base/random.hpp"
#include "simulation/contact/tolerances.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace frostfill
{
namespace
{

double gapAt(const World& world, const Eigen::Vector3d& p)
{
    double gap = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < world.surface.size(); ++t)
    {
        gap = std::min(gap, std::abs(signedDistance(world.surface, t, p).value) - 1);
    }
    for (std::size_t id = 0; id < world.spheres.size(); ++id)
    {
        gap = std::min(gap, (world.spheres.position(id) - p).norm() - 2);
    }
    return gap;
}

double pathFrom(const World& world, const Eigen::Vector3d& p, const Eigen::Vector3d& direction,
                double limit)
{
    NeighbourList around;
    around.ensure(world, p, 1, 0);
    return sphereCast(world.surface, around, p, 1, direction, limit);
}

TEST(SphereCast, EndsWhereTheFloorIsTouched)
{
    const auto world = smallWorld(shapes::box({-5, -5, -5}, {5, 5, 5}, 3));
    EXPECT_NEAR(pathFrom(*world, {0.3, -3.7, 0.2}, {0, -1, 0}, 0.5), 0.3, 1e-9);
}

TEST(SphereCast, EndsWhereASphereIsTouched)
{
    const auto world = smallWorld(shapes::box({-5, -5, -5}, {5, 5, 5}));
    addResting(*world, {0, -4, 0});
    EXPECT_NEAR(pathFrom(*world, {0, -1.6, 0}, {0, -1, 0}, 0.5), 0.4, 1e-12);
}

TEST(SphereCast, IsNotStoppedByTheFloorItSlidesAlong)
{
    const auto world = smallWorld(shapes::box({-5, -5, -5}, {5, 5, 5}, 7));
    EXPECT_EQ(pathFrom(*world, {0.1, -4, 0.2}, Eigen::Vector3d(1, 0, 0.3).normalized(), 0.5), 0.5);
}

TEST(SphereCast, TellsTheWayOutOfAWallIntoWhichASphereHasCrept)
{
    const auto world = smallWorld(shapes::box({-5, -5, -5}, {5, 5, 5}, 3));
    std::vector<Eigen::Vector3d> normals;
    const auto pushOut = [&](double depth)
    {
        const Eigen::Vector3d p(0.3, -4 - depth, 0.2);
        NeighbourList around;
        around.ensure(*world, p, 1, 0);
        return contactNormals(world->surface, around, p, 1, kTouch, normals);
    };
    EXPECT_EQ(pushOut(0.9 * kCrept), Eigen::Vector3d(0, 0, 0));
    EXPECT_LT((pushOut(3 * kCrept) - Eigen::Vector3d(0, 3 * kCrept, 0)).norm(), 1e-14);
    EXPECT_EQ(normals.size(), 1u);
}

// Brute force: what is passed over would have ended no cast. Beside a plane it is passed over on
// any way that does not lead to it.
TEST(SphereCast, MayTouchWhateverEndsIt)
{
    const auto world = smallWorld(shapes::torus(10, 4, 24, 10));
    const auto random = [](std::uint64_t k, std::uint64_t draw)
    { return 2 * uniformRandom(5, k, draw) - 1; };
    int ended = 0;
    int passedOver = 0;
    for (std::uint64_t k = 0; k < 20000; ++k)
    {
        const auto id = static_cast<std::uint32_t>(k % world->surface.size());
        const Eigen::Vector3d middle = world->surface.bound(id).centre;
        const Eigen::Vector3d p =
            middle + 3 * Eigen::Vector3d(random(k, 0), random(k, 1), random(k, 2));
        const Eigen::Vector3d direction =
            Eigen::Vector3d(random(k, 3), random(k, 4), random(k, 5)).normalized();
        const double limit = 4 * uniformRandom(5, k, 6);
        const bool ends = castAtTriangle(world->surface, id, p, 1, direction, limit) < limit;
        const bool may = mayTouch(world->surface.bound(id), p, 1, direction, limit);
        ASSERT_TRUE(may || !ends) << k;
        ended += ends ? 1 : 0;
        passedOver += may ? 0 : 1;
    }
    EXPECT_GT(ended, 1000);
    EXPECT_GT(passedOver, 5000);

    const auto box = smallWorld(shapes::box({-5, -5, -5}, {5, 5, 5}));
    for (std::uint32_t id = 0; id < box->surface.size(); ++id)
    {
        const bool isFloor = box->surface.bound(id).normal.y() > 0.5;
        EXPECT_EQ(mayTouch(box->surface.bound(id), {3.9, 3, 3.9}, 1, {0, -1, 0}, 7.5), isFloor);
    }
}

// Brute force: along the path no gap is negative, and where it ends early something is touched.
TEST(SphereCast, NeitherEntersAnythingNorStopsTooEarly)
{
    const auto world = smallWorld(shapes::torus(10, 4, 24, 10));
    for (std::uint64_t k = 0; k < 60; ++k)
    {
        const auto random = [&](std::uint64_t d) { return 2 * uniformRandom(11, k, d) - 1; };
        Eigen::Vector3d p(14 * random(0), 14 * random(1), 4 * random(2));
        if (gapAt(*world, p) > 0 && world->inside.contains(p))
        {
            addResting(*world, p);
        }
    }
    int stopped = 0;
    for (std::uint64_t trial = 0; trial < 3000; ++trial)
    {
        const auto random = [&](std::uint64_t d) { return 2 * uniformRandom(12, trial, d) - 1; };
        const Eigen::Vector3d p(14 * random(0), 14 * random(1), 4 * random(2));
        if (!world->inside.contains(p) || gapAt(*world, p) < 0)
        {
            continue;
        }
        const auto direction = Eigen::Vector3d(random(3), random(4), random(5)).normalized().eval();
        const double path = pathFrom(*world, p, direction, 0.5);
        for (int step = 0; step <= 20; ++step)
        {
            ASSERT_GT(gapAt(*world, p + direction * (path * step / 20)), -1e-9) << trial;
        }
        if (path < 0.5)
        {
            ++stopped;
            ASSERT_LT(gapAt(*world, p + direction * path), 1e-6) << trial;
        }
    }
    EXPECT_GT(stopped, 50);
}

} // namespace
} // namespace frostfill

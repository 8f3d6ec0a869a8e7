// SPDX-License-Identifier: MIT
#include "simulation/paper/algorithm1.hpp"

#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

// A room of 20 radii, spheres of radius 1, restitution 0.5.
class Algorithm1Test : public ::testing::Test
{
protected:
    std::uint32_t add(const Eigen::Vector3d& p, const Eigen::Vector3d& v = {0, 0, 0})
    {
        const auto id = spheres.add(p, 1, 0);
        spheres.running().velocity[spheres.row(id)] = v;
        return id;
    }
    void runAll()
    {
        const std::span<const Eigen::Vector3d> places = spheres.running().position.all();
        const std::vector<Eigen::Vector3d> before(places.begin(), places.end());
        algorithm.clearTouched();
        algorithm.runningRunning(counts);
        algorithm.runningFrozen(0, counts);
        algorithm.runningPolygons(before, counts);
    }

    Spheres spheres;
    Surface surface{shapes::box({-10, -10, -10}, {10, 10, 10}, 2)};
    std::vector<PolygonState> polygons = std::vector<PolygonState>(48, PolygonState::active);
    std::unique_ptr<PolygonSearchPart> search =
        makePolygonSearch(PolygonSearch::loop, {surface, polygons});
    Algorithm1 algorithm{spheres, surface, *search, {0.5, 0.01}};
    OperationCounts counts;
};

TEST_F(Algorithm1Test, HeadOnPairSeparatesWithTheClosedFormSpeeds)
{
    const auto a = add({-0.9, 0, 0}, {2, 0, 0});
    const auto b = add({0.9, 0, 0});
    runAll();
    EXPECT_DOUBLE_EQ(spheres.velocity(a).x(), 2 * (1 - 0.5) / 2);
    EXPECT_DOUBLE_EQ(spheres.velocity(b).x(), 2 * (1 + 0.5) / 2);
    EXPECT_DOUBLE_EQ(spheres.position(a).x(), -1);
    EXPECT_DOUBLE_EQ(spheres.position(b).x(), 1);
    EXPECT_EQ(counts.runningRunningTests, 1u);
    EXPECT_EQ(counts.runningRunningResponses, 2u);
}

TEST_F(Algorithm1Test, PairKeepsItsMomentumAndTangentialSpeed)
{
    const auto a = add({-0.6, -0.6, 0}, {1, 2, 3});
    const auto b = add({0.6, 0.6, 0}, {-2, -1, 0.5});
    const Eigen::Vector3d momentum = spheres.velocity(a) + spheres.velocity(b);
    runAll();
    EXPECT_LT((spheres.velocity(a) + spheres.velocity(b) - momentum).norm(), 1e-14);
    EXPECT_DOUBLE_EQ(spheres.velocity(a).z(), 3);
    EXPECT_DOUBLE_EQ(spheres.velocity(b).z(), 0.5);
}

TEST_F(Algorithm1Test, FrozenSphereNeverMovesByOneBit)
{
    const auto frozen = spheres.addResting({0.1, 0.2, 0.3}, 1, 0);
    const auto running = add({0.1, 1.7, 0.3}, {0, -1, 0});
    runAll();
    EXPECT_EQ(spheres.position(frozen), Eigen::Vector3d(0.1, 0.2, 0.3));
    EXPECT_EQ(spheres.velocity(frozen), Eigen::Vector3d(0, 0, 0));
    EXPECT_NEAR(spheres.position(running).y(), 2.2, 1e-14);
    EXPECT_NEAR(spheres.velocity(running).y(), 0.5, 1e-14);
    EXPECT_EQ(counts.runningFrozenTests, 1u);
    EXPECT_EQ(counts.runningFrozenResponses, 1u);
}

TEST_F(Algorithm1Test, WallReflectsWithRestitution)
{
    const auto id = add({3, -9.5, 2}, {1, -2, 0});
    runAll();
    EXPECT_NEAR(spheres.position(id).y(), -9, 1e-14);
    EXPECT_NEAR(spheres.velocity(id).y(), 1, 1e-14);
    EXPECT_NEAR(spheres.velocity(id).x(), 1, 1e-14);
    EXPECT_EQ(counts.spherePolygonTests, 48u);
}

TEST_F(Algorithm1Test, SlowApproachDoesNotBounce)
{
    const auto id = add({3, -9.05, 2}, {0, -0.009, 0});
    runAll();
    EXPECT_NEAR(spheres.velocity(id).y(), 0, 1e-16);
}

TEST_F(Algorithm1Test, CornerHoldsASphereAtItsRadiusFromThreeWalls)
{
    const auto id = add({-9.3, -9.3, -9.3});
    runAll();
    EXPECT_LT((spheres.position(id) - Eigen::Vector3d(-9, -9, -9)).norm(), 1e-12);
}

TEST_F(Algorithm1Test, CentreThatCrossedTheWallIsPulledBack)
{
    const auto id = add({3, -9.6, 2});
    const std::vector<Eigen::Vector3d> before = {spheres.position(id)};
    spheres.running().position[0].y() = -10.4;
    algorithm.clearTouched();
    algorithm.runningPolygons(before, counts);
    EXPECT_NEAR(spheres.position(id).y(), -9, 1e-12);
}

// It belongs to another sheet of a thin wall, whose triangles will deal with it.
TEST_F(Algorithm1Test, CentreThatWasBehindTheWallBeforeIsLeftAlone)
{
    const auto id = add({10.5, 0.3, 0.2});
    const std::vector<Eigen::Vector3d> before = {{10.4, 0.3, 0.2}};
    algorithm.clearTouched();
    algorithm.runningPolygons(before, counts);
    EXPECT_EQ(spheres.position(id).x(), 10.5);
    EXPECT_EQ(counts.spherePolygonResponses, 0u);
}

// Between walls that are nearer to each other than its diameter each undoes the other's push.
TEST_F(Algorithm1Test, StepThatWallsUndoIsTakenBackAndStartsFromRest)
{
    const Surface slab(shapes::box({-10, -10, -0.5}, {10, 10, 0.5}, 2));
    const auto slabSearch = makePolygonSearch(PolygonSearch::loop, {slab, polygons});
    Algorithm1 narrow(spheres, slab, *slabSearch, {0.5, 0.01});
    const auto id = add({0.3, 0.2, 0.1}, {0, 0, 1});
    const std::vector<Eigen::Vector3d> before = {{0.3, 0.2, 0.05}};
    narrow.clearTouched();
    narrow.runningPolygons(before, counts);
    EXPECT_EQ(spheres.position(id), before[0]);
    EXPECT_EQ(spheres.velocity(id), Eigen::Vector3d(0, 0, 0));
}

TEST_F(Algorithm1Test, CoincidentSpheresAreSeparated)
{
    const auto a = add({0, 0, 0});
    const auto b = add({0, 0, 0});
    runAll();
    EXPECT_NEAR((spheres.position(a) - spheres.position(b)).norm(), 2, 1e-14);
}

TEST_F(Algorithm1Test, DiscardedPolygonsAreNotTested)
{
    polygons.assign(48, PolygonState::discarded);
    search->update();
    const auto id = add({3, -9.5, 2}, {0, -1, 0});
    runAll();
    EXPECT_EQ(counts.spherePolygonTests, 0u);
    EXPECT_EQ(spheres.position(id).y(), -9.5);
}

} // namespace
} // namespace frostfill

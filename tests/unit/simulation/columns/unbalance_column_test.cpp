// SPDX-License-Identifier: MIT
#include "oracle/rest.hpp"
#include "simulation/quality/equilibrium.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"
#include "unit/simulation/columns/captured_column.hpp"
#include "unit/simulation/engine/small_torus.hpp"
#include "unit/simulation/quality/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

TEST(UnbalanceColumn, KnowsWhatIsMissingOnEachSphereAtRest)
{
    const auto world = smallWorld(room());
    const auto runs = world->spheres.add({5, 0, 5}, 1, 0);
    const auto stands = addResting(*world, {5, -9, 5});
    const auto left = addResting(*world, {-1, -9, 0});
    addResting(*world, {1, -9, 0});
    const auto top = addResting(*world, {0, -9 + std::sqrt(3.0), 0});
    const auto hangs = addResting(*world, {-6, 0, 0});
    test::CapturedColumn column(*world, "unbalance");
    column.capture();
    EXPECT_EQ(column[runs], 0);
    EXPECT_NEAR(column[stands], 0, 1e-3);
    EXPECT_NEAR(column[top], oracle::sinkingBetweenTwo(), 0.01);
    EXPECT_NEAR(column[left], oracle::sinkingBetweenTwo() * std::sqrt(3.0), 0.01);
    EXPECT_EQ(column[hangs], 1);
}

TEST(UnbalanceColumn, TellsOfAllThatChanges)
{
    const auto world = smallWorld(room());
    test::CapturedColumn column(*world, "unbalance");
    const auto low = addResting(*world, {0, -9, 0});
    const auto high = addResting(*world, {0, -7, 0});
    EXPECT_TRUE(column.capture().empty()) << "both stand";
    world->spheres.wake(low);
    EXPECT_EQ(column.capture(), std::vector{high});
    EXPECT_EQ(column[high], 1);
    world->spheres.freeze(low);
    world->spheres.closeRanks();
    EXPECT_EQ(column.capture(), std::vector{high});
    EXPECT_NEAR(column[high], 0, 1e-3);
}

TEST(UnbalanceColumn, FollowsThePullOfAMovingObject)
{
    const auto world = smallWorld(room());
    const auto low = addResting(*world, {0, -9, 0});
    test::CapturedColumn column(*world, "unbalance");
    column.capture();
    EXPECT_EQ(column[low], 0);
    world->pull.uniform = Eigen::Vector3d(1, -1, 0).normalized(); // it leans
    EXPECT_EQ(column.capture(), std::vector{low});
    EXPECT_NEAR(column[low], std::sqrt(0.5), 1e-3);
}

TEST(UnbalanceColumn, JudgesUnderTheFrictionOfTheScene)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.radius = 1;
    scene.judge.friction = 1;
    World world(scene, room());
    world.spheres.addResting({-1, -9, 0}, 1, 0);
    world.spheres.addResting({1, -9, 0}, 1, 0);
    const auto top = world.spheres.addResting({0, -9 + std::sqrt(3.0), 0}, 1, 0);
    EXPECT_LT(unbalanceAtRest(world)[world.spheres.row(top)], 0.1);
}

TEST(UnbalanceColumn, IsCarriedOnlyWhereItIsAskedFor)
{
    const auto has = [](const std::vector<ColumnValues>& columns)
    { return findValues(columns, *findColumn("unbalance")) != nullptr; };
    EXPECT_FALSE(has(carriedColumns()));
    EXPECT_FALSE(has(carriedColumns(std::vector<std::string>{"contacts"})));
    EXPECT_TRUE(has(carriedColumns(std::vector<std::string>{"unbalance"})));
    Scene scene = test::smallTorus();
    EXPECT_FALSE(has(Simulation(scene, shapes::torus()).columns()));
    scene.style.colourBy = "unbalance";
    EXPECT_TRUE(has(Simulation(scene, shapes::torus()).columns()));
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/world/set_recorder.hpp"

#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

TEST(SetRecorder, RecordsWhatCountersGainedWhileTheSetWasTheNewest)
{
    const auto world = smallWorld(shapes::box({-10, -10, -10}, {10, 10, 10}));
    world->counts.operations.runningFrozenTests = 1000;
    world->counts.times[Stage::freezing] = 5;
    world->clock.steps = 70;
    SetRecorder recorder;
    recorder.open(*world, 4);
    for (int k = 1; k <= 20; ++k)
    {
        recorder.observe(k, 100 * k);
    }
    world->counts.operations.runningFrozenTests += 30;
    world->counts.times[Stage::freezing] += 0.25;
    world->clock.steps += 20;
    addResting(*world, {0, 0, 0});
    world->spheres.discard(addResting(*world, {3, 0, 0}));
    world->spheres.add({6, 0, 0}, 1, 0);
    world->discardPolygon(0);
    recorder.close(*world);

    ASSERT_EQ(world->counts.sets.size(), 1u);
    const SetRecord& set = world->counts.sets[0];
    EXPECT_EQ(set.set, 0u);
    EXPECT_EQ(set.spheres, 4u);
    EXPECT_EQ(set.steps, 20u);
    EXPECT_EQ(set.operations.runningFrozenTests, 30u);
    EXPECT_DOUBLE_EQ(set.times[Stage::freezing], 0.25);
    EXPECT_DOUBLE_EQ(set.meanSphereSphereMs, 10.5);
    EXPECT_DOUBLE_EQ(set.meanSpherePolygonMs, 1050);
    EXPECT_EQ(set.p95SphereSphereMs, 19); // the nearest rank: the 19th of 20
    EXPECT_EQ(set.p95SpherePolygonMs, 1900);
    EXPECT_EQ(set.running, 1u);
    EXPECT_EQ(set.frozen, 1u);
    EXPECT_EQ(set.discarded, 1u);
    EXPECT_EQ(set.discardedPolygons, 1u);
}

TEST(SetRecorder, StartsEachSetAnew)
{
    const auto world = smallWorld(shapes::box({-10, -10, -10}, {10, 10, 10}));
    SetRecorder recorder;
    recorder.open(*world, 1);
    recorder.observe(50, 60);
    recorder.close(*world);
    recorder.open(*world, 2);
    recorder.observe(1, 2);
    recorder.close(*world);
    recorder.close(*world); // closed twice: nothing happens
    ASSERT_EQ(world->counts.sets.size(), 2u);
    EXPECT_EQ(world->counts.sets[1].set, 1u);
    EXPECT_EQ(world->counts.sets[1].meanSphereSphereMs, 1);
    EXPECT_EQ(world->counts.sets[1].p95SpherePolygonMs, 2);
}

} // namespace
} // namespace frostfill

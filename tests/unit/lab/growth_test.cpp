// SPDX-License-Identifier: MIT
#include "lab/growth.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

Scene fortySpheres()
{
    Scene scene = presetScene(Preset::paper, "cube");
    scene.spheres.count = 40;
    scene.spheres.groupSize = 5;
    scene.spheres.groupsPerSet = 1;
    scene.freezing.everySets = 1;
    scene.discard.rule = DiscardRule::none;
    scene.search = {SphereSearch::allPairs, PolygonSearch::loop};
    return scene;
}

TEST(GrowthStudy, TestsOfARunAreThoseOfLemma1AndLeaveTheLastSetOut)
{
    const auto points = growthOfRun(fortySpheres(), builtInMesh("cube"), 100);
    ASSERT_EQ(points.size(), 7u);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        EXPECT_EQ(points[i].spheres, 5 * (i + 1));
        EXPECT_DOUBLE_EQ(points[i].tests, 10.0 + 25.0 * static_cast<double>(i) + 5 * 768);
    }
}

TEST(GrowthStudy, WhatASphereCostsIsThatOfItsStepsInAll)
{
    const Scene scene = fortySpheres();
    Simulation simulation(scene, builtInMesh("cube"));
    while (simulation.step())
    {
    }
    const auto points = growthOfRun(scene, builtInMesh("cube"), 100);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const auto steps = static_cast<double>(simulation.sets()[i].steps);
        EXPECT_DOUBLE_EQ(points[i].testsOfSphere, points[i].tests * steps / 5);
        EXPECT_NEAR(points[i].msOfSphere, points[i].ms * steps / 5, 1e-9);
    }
}

TEST(GrowthStudy, WithoutFreezingEveryPairIsTested)
{
    const auto points = growthWithoutFreezing(fortySpheres(), builtInMesh("cube"), 4);
    ASSERT_EQ(points.size(), 4u);
    for (const GrowthPoint& point : points)
    {
        const auto n = static_cast<double>(point.spheres);
        EXPECT_DOUBLE_EQ(point.tests, n * (n - 1) / 2 + n * 768);
        EXPECT_GT(point.ms, 0);
    }
    EXPECT_EQ(points.back().spheres, 40u);
}

} // namespace
} // namespace frostfill

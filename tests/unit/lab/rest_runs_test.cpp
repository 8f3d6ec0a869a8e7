// SPDX-License-Identifier: MIT
#include "lab/pouring.hpp"
#include "lab/program_peer.hpp"
#include "lab/study.hpp"

#include <frostfill/packing.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace frostfill
{
namespace
{

/// By "curve setting, friction F".
using RestPoints = std::map<std::string, RestPoint>;

const RestPoints& restPoints()
{
    static const RestPoints kPoints = []
    {
        RestPoints points;
        for (const RestPoint& point : measureRest(true, {}, [](auto, auto, const auto&) {}))
        {
            points.emplace(
                fmt::format("{} {}, friction {:g}", point.curve, point.setting, point.friction),
                point);
        }
        return points;
    }();
    return kPoints;
}

TEST(RestRuns, LeaveNothingUnbalancedThatHasSettledTogether)
{
    std::size_t joint = 0;
    for (const auto& [name, point] : restPoints())
    {
        EXPECT_EQ(point.spheres, 300u) << name;
        if (point.curve == "joint")
        {
            ++joint;
            EXPECT_LE(point.unbalanced, 0.005) << name;
            const double least = point.leastFriction;
            EXPECT_LE(least, point.friction) << name;
            EXPECT_EQ(least > 0.05, point.friction > 0) << name << ": " << least;
            EXPECT_LE(point.maxOverlap, 1e-7) << name;
            EXPECT_TRUE(point.rests) << name;
        }
    }
    EXPECT_EQ(joint, 7u); // three motions with and without friction, grains with friction alone
}

TEST(RestRuns, FindThatSpheresWhichRestEachByThemselvesNeedFriction)
{
    for (const char* motion : {"fall", "skip", "descend"})
    {
        const std::string name = std::string("each ") + motion;
        EXPECT_GT(restPoints().at(name + ", friction 0").unbalanced, 0.9) << name;
        const RestPoint& held = restPoints().at(name + ", friction 0.3");
        EXPECT_LT(held.unbalanced, 0.05) << name;
        EXPECT_NEAR(held.leastFriction, 0.25, 0.1) << name;
        EXPECT_EQ(held.isDefault, std::string(motion) == "fall");
    }
}

// The program itself, which judges what it has run.
TEST(RestRuns, CountWhatTheProgramCounts)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = 1;
    scene.spheres.count = 300;
    scene.motion.mode = Motion::skip;
    scene.judge.friction = 0;
    Simulation simulation(scene, cubeFilledTo(0.4, 300));
    while (simulation.step())
    {
    }
    const EquilibriumReport report = simulation.quality().equilibrium.value();
    const RestPoint& point = restPoints().at("each skip, friction 0");
    EXPECT_NEAR(point.unbalanced * 300, static_cast<double>(report.unbalanced), 1);
    EXPECT_NEAR(point.leastFriction, report.leastFriction, 0.005);
    EXPECT_NEAR(point.largestUnbalance, report.largest, 0.02);
}

TEST(RestRuns, PourIntoACubeOfWhichSpheresTakeTheShareThatIsSaid)
{
    const double volume = 300 * 4.0 / 3 * std::numbers::pi;
    EXPECT_NEAR(volume / signedVolume(cubeFilledTo(0.4, 300)), 0.4, 1e-12);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "lab/peer.hpp"
#include "lab/pouring.hpp"
#include "lab/study.hpp"

#include <frostfill/packing.hpp>
#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace frostfill
{
namespace
{

/// By "curve setting friction".
using RestPoints = std::map<std::string, ErrorPoint>;

const ErrorStudy& restStudy()
{
    static const ErrorStudy kStudy = measureRest(true, {}, [](auto, auto, const auto&) {});
    return kStudy;
}

RestPoints restPoints()
{
    RestPoints points;
    for (const ErrorPoint& point : restStudy().points)
    {
        points.emplace(point.curve + " " + point.setting + ", " + point.rivals, point);
    }
    return points;
}

double detail(const ErrorPoint& point, const std::string& name)
{
    return restStudy().detail(point, name);
}

TEST(RestRuns, LeaveNothingUnbalancedThatHasSettledTogether)
{
    std::size_t joint = 0;
    for (const auto& [name, point] : restPoints())
    {
        EXPECT_EQ(point.details.size(), 6u) << name;
        EXPECT_EQ(detail(point, "spheres"), 300) << name;
        if (point.curve == "joint")
        {
            ++joint;
            EXPECT_LE(point.error, 0.005) << name;
            const double least = detail(point, "least_friction");
            EXPECT_LE(least, detail(point, "friction")) << name;
            EXPECT_EQ(least > 0.05, detail(point, "friction") > 0) << name << ": " << least;
            EXPECT_LE(detail(point, "max_overlap"), 1e-7) << name;
            EXPECT_EQ(detail(point, "rests"), 1) << name;
        }
    }
    EXPECT_EQ(joint, 7u); // three motions with and without friction, grains with friction alone
}

TEST(RestRuns, FindThatSpheresWhichRestEachByThemselvesNeedFriction)
{
    for (const char* motion : {"fall", "skip", "descend"})
    {
        const std::string name = std::string("each ") + motion;
        EXPECT_GT(restPoints().at(name + ", friction 0").error, 0.9) << name;
        const ErrorPoint held = restPoints().at(name + ", friction 0.3");
        EXPECT_LT(held.error, 0.05) << name;
        EXPECT_NEAR(detail(held, "least_friction"), 0.25, 0.1) << name;
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
    const ErrorPoint point = restPoints().at("each skip, friction 0");
    EXPECT_NEAR(point.error * 300, static_cast<double>(report.unbalanced), 1);
    EXPECT_NEAR(detail(point, "least_friction"), report.leastFriction, 0.005);
    EXPECT_NEAR(detail(point, "largest_unbalance"), report.largest, 0.02);
}

TEST(RestRuns, PourIntoACubeOfWhichSpheresTakeTheShareThatIsSaid)
{
    const double volume = 300 * 4.0 / 3 * std::numbers::pi;
    EXPECT_NEAR(volume / signedVolume(cubeFilledTo(0.4, 300)), 0.4, 1e-12);
}

} // namespace
} // namespace frostfill

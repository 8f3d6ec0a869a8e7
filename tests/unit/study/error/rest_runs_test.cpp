// SPDX-License-Identifier: MIT
#include "study/error/error_runs.hpp"
#include "study/peers/peer.hpp"
#include "study/peers/pouring.hpp"

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

const RestPoints& restPoints()
{
    static const RestPoints kPoints = []
    {
        std::vector<ErrorTask> tasks;
        addRestRuns(tasks, true);
        RestPoints points;
        for (const ErrorTask& task : tasks)
        {
            const ErrorPoint point = task();
            points.emplace(point.curve + " " + point.setting + ", " + point.rivals, point);
        }
        return points;
    }();
    return kPoints;
}

double detail(const ErrorPoint& point, const std::string& name)
{
    for (const ErrorStudyInfo& study : errorStudies())
    {
        for (std::size_t k = 0; k < study.details.size(); ++k)
        {
            if (study.name == point.study && study.details[k] == name)
            {
                return point.details.at(k);
            }
        }
    }
    ADD_FAILURE() << "no detail " << name;
    return 0;
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
        const ErrorPoint& held = restPoints().at(name + ", friction 0.3");
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
    const ErrorPoint& point = restPoints().at("each skip, friction 0");
    EXPECT_NEAR(point.error * 300, static_cast<double>(report.unbalanced), 1);
    EXPECT_NEAR(detail(point, "least_friction"), report.leastFriction, 0.005);
    EXPECT_NEAR(detail(point, "largest_unbalance"), report.largest, 0.02);
}

// What has settled without friction needs none; with friction it is held before it is that dense.
TEST(RestRuns, JudgeLiggghtsUnderTheFrictionThatItHas)
{
    std::size_t theirs = 0;
    for (const auto& [name, point] : restPoints())
    {
        if (point.curve == "LIGGGHTS")
        {
            ++theirs;
            EXPECT_LT(point.error, 0.05) << name;
            EXPECT_GT(detail(point, "max_overlap"), 1e-3) << "soft spheres: " << name;
            const double least = detail(point, "least_friction");
            EXPECT_EQ(least > 0.03, detail(point, "friction") > 0) << name << ": " << least;
        }
    }
    EXPECT_EQ(theirs, hasLiggghts() ? 4u : 0u);
}

TEST(RestRuns, PourIntoACubeOfWhichSpheresTakeTheShareThatIsSaid)
{
    const double volume = 300 * 4.0 / 3 * std::numbers::pi;
    EXPECT_NEAR(volume / signedVolume(cubeFilledTo(0.4, 300)), 0.4, 1e-12);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/shapes.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

Scene sceneOfFraction(std::optional<double> fraction)
{
    Scene scene = presetScene(Preset::fast, "box");
    scene.spheres.radius = 0.1;
    scene.spheres.count.reset();
    scene.motion.mode = Motion::skip;
    scene.rest.mode = Rest::joint;
    scene.rest.friction = 0.4;
    scene.rest.fraction = fraction;
    scene.judge.friction = 0.4;
    return scene;
}

QualityReport reportOf(const Scene& scene)
{
    Simulation simulation(scene, shapes::box({-0.9, -0.9, -0.9}, {0.9, 0.9, 0.9}));
    while (simulation.step())
    {
    }
    return simulation.quality();
}

TEST(FractionOfRest, IsReachedAndHeldByFriction)
{
    const QualityReport report = reportOf(sceneOfFraction(0.63));
    ASSERT_TRUE(report.settling && report.settling->fraction && report.equilibrium);
    EXPECT_TRUE(report.settling->settled);
    EXPECT_GE(*report.settling->fraction, 0.629);
    EXPECT_LE(*report.settling->fraction, 0.642); // three spheres in so small a bulk
    EXPECT_EQ(report.equilibrium->unbalanced, 0U);
    EXPECT_LE(report.maxOverlap, 1e-7);
    EXPECT_EQ(report.centresOutside, 0U);
}

TEST(FractionOfRest, LeavesAloneWhatIsDenserAlready)
{
    const QualityReport asked = reportOf(sceneOfFraction(0.51));
    const QualityReport usual = reportOf(sceneOfFraction(std::nullopt));
    ASSERT_TRUE(asked.settling->fraction);
    EXPECT_GT(*asked.settling->fraction, 0.55);
    EXPECT_EQ(asked.settling->rounds, usual.settling->rounds);
    EXPECT_EQ(asked.settling->missing, usual.settling->missing);
    EXPECT_FALSE(usual.settling->fraction);
}

TEST(FractionOfRest, EndsWhereNothingFlowsAnyMore)
{
    const QualityReport report = reportOf(sceneOfFraction(RestSettings::kDensest));
    EXPECT_TRUE(report.settling->settled);
    EXPECT_LT(*report.settling->fraction, 0.68);
    EXPECT_GT(*report.settling->fraction, 0.6);
}

// The same grains: what is asked for decides how densely they lie, without a leap.
TEST(FractionOfRest, IsReachedByGrainsFromTheLoosestOn)
{
    Scene scene = sceneOfFraction(RestSettings::kLoosest);
    scene.motion.mode = Motion::granular;
    scene.rest.friction = 1;
    scene.judge.friction = 1;
    const QualityReport loosest = reportOf(scene);
    EXPECT_TRUE(loosest.settling->settled);
    EXPECT_LT(*loosest.settling->fraction, 0.59);
    EXPECT_GT(*loosest.settling->fraction, 0.55);
    EXPECT_EQ(loosest.equilibrium->unbalanced, 0U);
    scene.rest.friction = 0.3;
    for (const double fraction : {0.599, 0.6, 0.62})
    {
        scene.rest.fraction = fraction;
        const QualityReport report = reportOf(scene);
        EXPECT_TRUE(report.settling->settled);
        EXPECT_NEAR(*report.settling->fraction, fraction, 0.002);
    }
}

TEST(FractionOfRest, IsRefusedWhereItHasNoMeaning)
{
    const auto refuse = [](ErrorCode code, auto change, const char* words)
    {
        Scene scene = sceneOfFraction(0.62);
        change(scene);
        test::expectError(
            code, [&] { reportOf(scene); }, words);
    };
    refuse(
        ErrorCode::usage, [](Scene& s) { s.rest.friction = 0; }, "--friction");
    refuse(
        ErrorCode::usage, [](Scene& s) { s.rest.mode = Rest::each; }, "--rest");
    refuse(
        ErrorCode::usage, [](Scene& s) { s.rest.fraction = RestSettings::kLoosest; }, "granular");
    refuse(
        ErrorCode::usage, [](Scene& s) { s.rest.fraction = 0.8; }, "--fraction");
    refuse(
        ErrorCode::badData, [](Scene& s) { s.spheres.radius = 0.3; }, "no bulk");
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "support/temporary_folder.hpp"
#include "sweep/trial.hpp"

#include <frostfill/plan.hpp>
#include <frostfill/plan_fill.hpp>
#include <frostfill/sweep.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

double bytesIn(const std::filesystem::path& folder)
{
    double bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        bytes += entry.is_regular_file() ? static_cast<double>(entry.file_size()) : 0;
    }
    return bytes;
}

/// The estimate is of the right size: within `factor`, both ways.
void expectWithin(double factor, double estimate, double actual)
{
    EXPECT_GT(estimate, actual / factor);
    EXPECT_LT(estimate, actual * factor);
}

TEST(PlanTimes, TakeThePicturesApartFromTheRest)
{
    const PictureTimes times = timesOf(3, 4, 8, 24);
    EXPECT_DOUBLE_EQ(times.each, 0.25);
    EXPECT_DOUBLE_EQ(times.before, 2);
    // What is too short for the clock takes no less than nothing.
    EXPECT_EQ(timesOf(3, 4, 2, 24).each, 0);
    EXPECT_EQ(timesOf(3, 4, 2, 24).before, 3);
    EXPECT_EQ(timesOf(0.5, 4, 20.5, 24).before, 0);
    // A run with as few pictures as that: all of its time is theirs.
    EXPECT_DOUBLE_EQ(timesOf(3, 1, 3, 1).each, 3);
    EXPECT_EQ(timesOf(3, 1, 3, 1).before, 0);
}

TEST(PlanTimes, OfARunThatWasTriedAreItsOwn)
{
    const Trial trial = {.spheres = 500, .time = {2, 0.25}, .pictureBytes = 10, .otherBytes = 70};
    const Cost cost = costFrom(trial, {}, 500, 200);
    EXPECT_DOUBLE_EQ(cost.seconds, 2 + 200 * 0.25);
    EXPECT_DOUBLE_EQ(cost.bytes, 200 * 10 + 70);
    EXPECT_DOUBLE_EQ(costFrom(trial, {}, 1000, 0).bytes, 2 * 70);
}

TEST(PlanTimes, OfALargeRunGrowByThePowerThatTwoModelsShow)
{
    const Trial trial = {.spheres = 2000, .time = {8, 0.25}, .pictureBytes = 10, .otherBytes = 70};
    const auto secondsOf = [&](double smaller)
    {
        return costFrom(trial, Trial{.spheres = 500, .time = {smaller, 0.25}}, 32000, 100).seconds -
               100 * 0.25;
    };
    EXPECT_DOUBLE_EQ(secondsOf(8 / 4.0), 8 * 16); // four times as many take four times as long
    EXPECT_NEAR(secondsOf(8 / std::pow(4, 1.5)), 8 * std::pow(16, 1.5), 1e-9);
    // What two short runs show is believed within limits.
    EXPECT_NEAR(secondsOf(8), 8 * std::pow(16, kMinPower), 1e-9);
    EXPECT_NEAR(secondsOf(8 / 64.0), 8 * std::pow(16, kLargestPower), 1e-9);
}

TEST(PlanSweep, IsOfTheSizeOfWhatTheRunsTake)
{
    const test::TemporaryFolder folder;
    SweepRequest sweep;
    sweep.runs =
        parseSweep("[scene]\nobject.mesh = \"cube\"\nframes.which = \"none\"\nthreads = 1\n"
                   "[sweep]\nspheres.radius = [0.05, 0.2]\nseed = [1, 2]\n",
                   "sweep.toml");
    sweep.directory = folder / "out";
    const std::vector<Cost> costs = planSweep(sweep.runs);
    ASSERT_EQ(costs.size(), 4U);
    EXPECT_EQ(costs[0].seconds, costs[1].seconds);  // seeds are alike
    EXPECT_GT(costs[0].bytes, 10 * costs[2].bytes); // 64 times as many spheres
    (void)runSweep(sweep);
    double bytes = 0;
    for (const Cost& cost : costs)
    {
        EXPECT_GT(cost.seconds, 0);
        bytes += cost.bytes;
        EXPECT_GT(cost.memory, 1e6);
    }
    expectWithin(2, bytes, bytesIn(folder / "out"));
}

TEST(PlanSweep, CountsWhatPicturesTake)
{
    const auto costOf = [](const std::string& frames)
    {
        const auto runs = parseSweep("[scene]\nobject.mesh = \"cube\"\nthreads = 1\n" + frames +
                                         "[sweep]\nspheres.radius = [0.4]\n",
                                     "sweep.toml");
        return planSweep(runs).at(0);
    };
    const Cost none = costOf("frames.which = \"none\"\n");
    const Cost sixty = costOf("picture.size = \"640x480\"\nframes.duration = 2\n");
    const Cost twice = costOf("picture.size = \"640x480\"\nframes.duration = 4\n");
    EXPECT_GT(sixty.bytes, 4 * none.bytes);
    expectWithin(1.3, twice.bytes, 2 * sixty.bytes);
}

TEST(PlanRender, IsOfTheSizeOfWhatThePicturesTake)
{
    const test::TemporaryFolder folder;
    FillRequest request;
    request.scene = presetScene(Preset::fast, "torus");
    request.scene.size = {320, 240};
    request.scene.frames.duration = 2;
    request.directory = folder / "run";
    (void)fill(request);
    RenderRequest again;
    again.run = folder / "run";
    const RenderPlan plan = planRender(again);
    const RenderResult result = renderRun(again);
    EXPECT_EQ(plan.pictures, result.frames);
    EXPECT_EQ(planRender(again).pictures, plan.pictures); // also when they are there already
    const auto pictures = static_cast<double>(plan.pictures);
    EXPECT_GE(plan.secondsBefore, 0);
    EXPECT_GT(plan.secondsPerPicture, 0);
    expectWithin(1.5, pictures * plan.bytesPerPicture, bytesIn(folder / "run/render"));
}

TEST(PlanFill, ChecksAndCountsButWritesNothing)
{
    const test::TemporaryFolder folder;
    FillRequest request;
    request.scene = presetScene(Preset::fast, "torus");
    request.scene.spheres.count = 30;
    request.scene.size = {96, 72};
    request.scene.frames.duration = 0.5;
    request.directory = folder / "not/there/yet";
    const FillPlan plan = planFill(request);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    const FillResult result = fill(request);
    EXPECT_EQ(plan.spheres, result.wanted);
    EXPECT_NEAR(static_cast<double>(plan.frames), static_cast<double>(result.frames), 2);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "base/processor_time.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/plan.hpp>
#include <frostfill/plan_fill.hpp>
#include <frostfill/sweep.hpp>

#include <gtest/gtest.h>

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
    EXPECT_EQ(costs[0].seconds, costs[1].seconds); // seeds are alike
    EXPECT_GT(costs[0].seconds, costs[2].seconds); // ten times as many spheres and more
    const double before = ProcessorClock::now();
    (void)runSweep(sweep);
    const double seconds = ProcessorClock::now() - before;
    double estimate = 0;
    double bytes = 0;
    for (const Cost& cost : costs)
    {
        estimate += cost.seconds;
        bytes += cost.bytes;
        EXPECT_GT(cost.memory, 1e6);
    }
    expectWithin(3, estimate, seconds);
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
    EXPECT_GT(sixty.seconds, 4 * none.seconds);
    expectWithin(1.6, twice.seconds, 2 * sixty.seconds);
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
    const double before = ProcessorClock::now();
    const RenderResult result = renderRun(again);
    const double seconds = ProcessorClock::now() - before;
    EXPECT_EQ(plan.pictures, result.frames);
    EXPECT_EQ(planRender(again).pictures, plan.pictures); // also when they are there already
    const auto pictures = static_cast<double>(plan.pictures);
    expectWithin(3, plan.secondsBefore + pictures * plan.secondsPerPicture, seconds);
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

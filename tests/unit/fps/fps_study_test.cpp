// SPDX-License-Identifier: MIT
#include "fps/fps_compare.hpp"
#include "fps/fps_report.hpp"
#include "fps/fps_run.hpp"
#include "fps/paper_numbers.hpp"
#include "support/expect_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

FpsResult smallMeasurement()
{
    FpsRequest request;
    request.scenes = {presetScene(Preset::paper, "cube")};
    // Small enough that a whole set finds room at once.
    request.scenes.front().spheres.radius = Radii(0.13);
    request.scenes.front().spheres.count = 84;
    request.repeats = 2;
    request.pictures = false;
    return measureFps(request, [](const std::string&) {});
}

class FpsStudy : public ::testing::Test
{
protected:
    static const FpsResult& result()
    {
        static const FpsResult kResult = smallMeasurement();
        return kResult;
    }
    static const FpsObject& cube() { return result().objects.front(); }
};

TEST_F(FpsStudy, TheSearchesOfThePaperEndInTheSameState)
{
    ASSERT_EQ(cube().methods.size(), 5u);
    for (std::size_t i = 1; i < 4; ++i)
    {
        EXPECT_EQ(cube().methods[i].stateHash, cube().methods[0].stateHash);
    }
}

TEST_F(FpsStudy, TheSecondSetRunsTogetherWithTheFirst)
{
    const FpsMethodResult& loop = cube().methods.front();
    ASSERT_EQ(loop.sets.size(), 4u);
    ASSERT_EQ(loop.places.size(), 2u);
    EXPECT_EQ(loop.places[0].running, 21u);
    EXPECT_EQ(loop.places[1].running, 42u);
    EXPECT_EQ(loop.sets[2].place, 1u);
    EXPECT_EQ(loop.sets[2].frozen + loop.sets[2].discarded, 42u);
}

// Against all steps of a run of its own: the steps of a run are always the same.
TEST_F(FpsStudy, WarmUpStepsDoNotCount)
{
    const FpsRequest& request = result().request;
    const FpsMethodResult& loop = cube().methods.front();
    std::vector<std::size_t> steps(loop.sets.size());
    const Scene scene = sceneFor(cube().scene, FpsMethod::loop);
    for (const FpsStep& step : timeRun(scene, builtInMesh("cube")).steps)
    {
        ++steps.at(step.set);
    }
    ASSERT_GT(steps.front(), request.warmUpSteps);
    steps.front() -= request.warmUpSteps;
    std::size_t counted = 0;
    for (std::size_t set = 0; set < steps.size(); ++set)
    {
        EXPECT_EQ(loop.sets[set].step.count, request.repeats * steps[set]) << set;
        counted += request.repeats * steps[set];
    }
    EXPECT_EQ(loop.step.count, counted);
}

TEST_F(FpsStudy, ThePaperStandsBesideOurs)
{
    const Table table = fpsTables(result()).front();
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0][3], rangeText(paperNumbers("cube")->spherePolygonMs[0]));
    EXPECT_EQ(table.rows[1][3], "35");
    for (const auto& each : fpsTables(result()))
    {
        for (const auto& row : each.rows)
        {
            EXPECT_EQ(row.size(), each.headings.size()) << each.title;
        }
    }
}

TEST_F(FpsStudy, EverySetIsARowOfTheCsv)
{
    const Table table = fpsSetTable(result());
    EXPECT_GE(table.rows.size(), 5u * 4 - 1);
    for (const auto& row : table.rows)
    {
        ASSERT_EQ(row.size(), table.headings.size());
    }
}

TEST_F(FpsStudy, FramesASecondFallWithEveryStageAdded)
{
    const PictureMs picture = {4, 7, 10, 2, 8};
    const FramesPerSecond fps = framesPerSecond(5, &picture);
    EXPECT_DOUBLE_EQ(fps.simulation, 200);
    EXPECT_DOUBLE_EQ(fps.drawing, 1000.0 / 15);
    EXPECT_DOUBLE_EQ(fps.readback, 1000.0 / 17);
    EXPECT_DOUBLE_EQ(fps.png, 40);
    EXPECT_EQ(framesPerSecond(5, nullptr).png, 0);
    EXPECT_EQ(cube().picturesOf(FpsMethod::fast), nullptr);
}

TEST(FpsPictures, AreThoseOfEachMethodAndTellTheirParts)
{
    FpsRequest request;
    request.scenes = {presetScene(Preset::paper, "cube")};
    request.scenes.front().spheres.radius = Radii(0.13);
    request.scenes.front().spheres.count = 42;
    request.scenes.front().size = {160, 90};
    request.repeats = 1;
    request.methods = {FpsMethod::grid, FpsMethod::fast};
    const FpsResult result = measureFps(request, [](const std::string&) {});
    const FpsObject& cube = result.objects.front();
    ASSERT_EQ(cube.picturesOf(FpsMethod::loop), &cube.paperPictures);
    ASSERT_EQ(cube.picturesOf(FpsMethod::fast), &cube.fastPictures);
    for (const FpsPictures* pictures : {&cube.paperPictures, &cube.fastPictures})
    {
        EXPECT_GE(pictures->sets.size(), 2u);
        EXPECT_GT(pictures->running, 0);
        if (pictures->mean.osmesa > 0) // it is there
        {
            EXPECT_GT(pictures->apart, 0);
            EXPECT_LT(pictures->apart, 1);
        }
        for (const double part : {pictures->mean.spheres, pictures->mean.samples,
                                  pictures->mean.render, pictures->mean.encode})
        {
            EXPECT_GT(part, 0) << "is measured";
        }
    }
    // The paper's second set runs together with the first, ours freezes one by one.
    EXPECT_GT(cube.paperPictures.running, cube.fastPictures.running);
    const auto json = fpsJson(result)["objects"][0]["pictures"];
    EXPECT_EQ(json["paper"]["running"], cube.paperPictures.running);
    EXPECT_EQ(json["fast"]["render_ms"], cube.fastPictures.mean.render);
}

TEST_F(FpsStudy, AMeasurementHasNotRegressedAgainstItself)
{
    const auto json = fpsJson(result());
    const FpsComparison comparison = compareFps(json, json, 0, "itself");
    EXPECT_EQ(comparison.changes.size(), 5u + 4);
    EXPECT_FALSE(comparison.regressed());
    EXPECT_TRUE(comparison.sameMachine);
}

TEST_F(FpsStudy, WhatTakesLongerThanTheThresholdHasRegressed)
{
    const auto now = fpsJson(result());
    auto before = now;
    auto& run = before["objects"][0]["searches"][2]["step_ms_of_runs"]["fastest_run"];
    run = run.get<double>() / 1.2;
    EXPECT_FALSE(compareFps(before, now, 25, "before").regressed());
    const FpsComparison comparison = compareFps(before, now, 15, "before");
    EXPECT_TRUE(comparison.regressed());
    const auto change = std::find_if(comparison.changes.begin(), comparison.changes.end(),
                                     [](const FpsChange& each) { return each.regressed; });
    EXPECT_EQ(change->search, "tree");
    EXPECT_NEAR(change->percent(), 20, 1e-9);
}

TEST_F(FpsStudy, DifferentWorkIsNotCompared)
{
    const auto now = fpsJson(result());
    auto before = now;
    before["objects"][0]["spheres"] = 300;
    const nlohmann::ordered_json other = {{"a", 1}};
    test::expectError(
        ErrorCode::badData, [&] { (void)compareFps(before, now, 15, "before.json"); },
        "before.json", "in common");
    test::expectError(
        ErrorCode::badData, [&] { (void)compareFps(other, now, 15, "other.json"); }, "other.json",
        "was not written by");
}

TEST(PaperNumbers, AreKnownForTheFourObjectsAlone)
{
    for (const std::string& name : builtInMeshNames())
    {
        ASSERT_NE(paperNumbers(name), nullptr) << name;
    }
    EXPECT_EQ(paperNumbers("bunny.obj"), nullptr);
    EXPECT_EQ(rangeText({13, 25}), "13–25");
    EXPECT_EQ(paperNumbers("human")->spherePolygonMs.size(), 3u);
}

} // namespace
} // namespace frostfill

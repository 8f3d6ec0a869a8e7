// SPDX-License-Identifier: MIT
#include "support/small_runs.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <tuple>
#include <vector>

// What an animation promises, looked at in the pictures themselves.
namespace frostfill
{
namespace
{

using test::picture;
using test::pictureText;
using test::TemporaryFolder;

struct Kind
{
    const char* object;
    Preset preset;
    Motion motion;
};

std::string nameOf(const ::testing::TestParamInfo<Kind>& info)
{
    const Kind& kind = info.param;
    const char* motions[] = {"fall", "skip", "descend"};
    return std::string(kind.object) + "_" +
           (kind.preset == Preset::paper ? "paper" : motions[static_cast<int>(kind.motion)]);
}

std::vector<Kind> everyKind()
{
    std::vector<Kind> kinds;
    for (const char* object : {"torus", "sphere", "cube", "human"})
    {
        kinds.push_back({object, Preset::paper, Motion::fall});
        for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
        {
            kinds.push_back({object, Preset::fast, motion});
        }
    }
    return kinds;
}

FillRequest requestOf(const Kind& kind, std::uint64_t count, const std::filesystem::path& folder)
{
    FillRequest request = test::smallPictures(presetScene(kind.preset, kind.object), folder);
    request.scene.motion.mode = kind.motion;
    request.scene.spheres.count = count;
    return request;
}

class Animation : public ::testing::TestWithParam<Kind>
{
};

TEST_P(Animation, ItsLastPictureShowsTheFinalState)
{
    for (const bool untilFull : {false, true})
    {
        const TemporaryFolder folder;
        FillRequest request = requestOf(GetParam(), 30, folder / "run");
        request.scene.spheres.untilFull = untilFull;
        request.scene.frames.duration = 1;
        request.scene.frames.hold = untilFull ? 0.1 : 0;
        const FillResult result = fill(request);
        const auto summary = nlohmann::json::parse(result.summary);
        const auto last = picture(folder / "run", result.frames - 1);
        EXPECT_EQ(pictureText(last, "State"), test::stateOf(summary))
            << (untilFull ? "until full" : "up to the count");
    }
}

// Of 60 pictures and of 20 that are spread over the same time.
TEST_P(Animation, PlaysAsAnnouncedAndAtTheSpeedThatTheSummaryTells)
{
    for (const std::size_t limit : {0U, 20U})
    {
        const TemporaryFolder folder;
        FillRequest request = requestOf(GetParam(), 60, folder / "run");
        request.scene.frames.duration = 2;
        request.scene.frames.limit = limit;
        FillPlan plan;
        FillObserver observer;
        observer.planned = [&](const FillPlan& announced) { plan = announced; };
        const FillResult result = fill(request, observer);
        const auto announced = static_cast<double>(plan.frames);
        const auto kept = static_cast<double>(result.frames);
        EXPECT_NEAR(kept, announced, 0.1 * announced);
        EXPECT_NEAR(plan.videoSeconds, 2, 0.1);

        const auto summary = nlohmann::json::parse(result.summary);
        const double rate = summary["frames_per_second"];
        EXPECT_NEAR(kept / rate, 2, limit == 0 ? 0.1 : 0.35);
        const std::size_t first = result.frames / 4;
        const std::size_t last = 3 * result.frames / 4;
        const auto pictures = test::pictures(folder / "run");
        ASSERT_EQ(pictures.size(), result.frames);
        const double simulated = test::timeOf(pictures[last]) - test::timeOf(pictures[first]);
        const double played = static_cast<double>(last - first) / rate;
        // A picture shows the first state at or after its time.
        const double step = summary["time"]["step"];
        EXPECT_NEAR(simulated, played / summary["slow_motion"].get<double>(), 1.01 * step);
    }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, Animation, ::testing::ValuesIn(everyKind()), nameOf);

// Spheres and polygons turn pale one by one and not in a cut.
TEST(AnimationOfDiscards, NoTwoPicturesOfADefaultRunDifferByMoreThanAFewPercentOfTheObject)
{
    const TemporaryFolder folder;
    const FillRequest request =
        requestOf({"torus", Preset::fast, Motion::fall}, 320, folder / "run");
    const FillResult result = fill(request);
    const auto summary = nlohmann::json::parse(result.summary);
    const double spheres = summary["spheres"]["total"];
    const double polygons = summary["polygons"]["total"];
    double spheresBefore = 0;
    double polygonsBefore = 0;
    for (std::size_t i = 0; i < result.frames; ++i)
    {
        std::istringstream text(pictureText(picture(folder / "run", i), "State"));
        double running = 0, frozen = 0, discarded = 0, discardedPolygons = 0;
        std::string word;
        text >> running >> word >> frozen >> word >> discarded >> word >> discardedPolygons;
        EXPECT_LE(discarded - spheresBefore, 0.05 * spheres) << "picture " << i;
        EXPECT_LE(discardedPolygons - polygonsBefore, 0.05 * polygons) << "picture " << i;
        spheresBefore = discarded;
        polygonsBefore = discardedPolygons;
    }
    EXPECT_GT(spheresBefore, 0.5 * spheres);
}

} // namespace
} // namespace frostfill

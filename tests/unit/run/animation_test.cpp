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

std::string nameOf(const Kind& kind)
{
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
        for (const double hold : {0.0, 0.1})
        {
            const TemporaryFolder folder;
            FillRequest request = requestOf(GetParam(), 30, folder / "run");
            request.scene.spheres.untilFull = untilFull;
            request.scene.frames.duration = 1;
            request.scene.frames.hold = hold;
            const FillResult result = fill(request);
            const auto summary = nlohmann::json::parse(result.summary);
            const auto last = picture(folder / "run", result.frames - 1);
            EXPECT_EQ(pictureText(last, "State"), test::stateOf(summary))
                << "until full: " << untilFull << ", held: " << hold;
        }
    }
}

TEST_P(Animation, AsManyFramesComeAsWereAnnounced)
{
    const TemporaryFolder folder;
    const FillRequest request = requestOf(GetParam(), 60, folder / "run");
    FillPlan plan;
    FillObserver observer;
    observer.planned = [&](const FillPlan& announced) { plan = announced; };
    const FillResult result = fill(request, observer);
    EXPECT_NEAR(static_cast<double>(result.frames), static_cast<double>(plan.frames),
                0.1 * static_cast<double>(plan.frames));
    EXPECT_LE(plan.videoSeconds, 20.1);
}

TEST_P(Animation, PlaysAtTheSpeedThatTheSummaryTells)
{
    for (const std::size_t limit : {0U, 20U})
    {
        const TemporaryFolder folder;
        FillRequest request = requestOf(GetParam(), 60, folder / "run");
        request.scene.frames.duration = 3;
        request.scene.frames.limit = limit;
        const FillResult result = fill(request);
        const auto summary = nlohmann::json::parse(result.summary);
        const std::size_t first = result.frames / 4;
        const std::size_t last = 3 * result.frames / 4;
        const double simulated = test::timeOf(picture(folder / "run", last)) -
                                 test::timeOf(picture(folder / "run", first));
        const double played =
            static_cast<double>(last - first) / summary["frames_per_second"].get<double>();
        // A picture shows the first state at or after its time.
        const double step = summary["time"]["step"];
        EXPECT_NEAR(simulated, played / summary["slow_motion"].get<double>(), 1.01 * step);
        EXPECT_NEAR(static_cast<double>(result.frames) / summary["frames_per_second"].get<double>(),
                    3, limit == 0 ? 0.1 : 0.35);
    }
}

INSTANTIATE_TEST_SUITE_P(EveryKind, Animation, ::testing::ValuesIn(everyKind()),
                         [](const auto& info) { return nameOf(info.param); });

// Spheres and polygons turn pale one by one and not in a cut.
TEST(AnimationOfDiscards, NoTwoPicturesDifferByMoreThanAFewPercentOfTheObject)
{
    for (const bool untilFull : {false, true})
    {
        const TemporaryFolder folder;
        FillRequest request = requestOf({"torus", Preset::fast, Motion::fall}, 300, folder / "run");
        request.scene.spheres.untilFull = untilFull;
        const FillResult result = fill(request);
        const auto summary = nlohmann::json::parse(result.summary);
        const double spheres = summary["spheres"]["total"];
        const double polygons = summary["polygons"]["total"];
        double before[2] = {0, 0};
        for (std::size_t i = 0; i < result.frames; ++i)
        {
            std::istringstream text(pictureText(picture(folder / "run", i), "State"));
            double running = 0, frozen = 0, discarded = 0, discardedPolygons = 0;
            std::string word;
            text >> running >> word >> frozen >> word >> discarded >> word >> discardedPolygons;
            EXPECT_LE(discarded - before[0], 0.06 * spheres) << "picture " << i;
            EXPECT_LE(discardedPolygons - before[1], 0.06 * polygons) << "picture " << i;
            before[0] = discarded;
            before[1] = discardedPolygons;
        }
        EXPECT_GT(before[0], 0.5 * spheres);
    }
}

} // namespace
} // namespace frostfill

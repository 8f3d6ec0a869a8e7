// SPDX-License-Identifier: MIT
// Which frames become pictures. The oracle is a folder of pictures, kept as a list of what they
// show.
#include "run/picture_plan.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

/// A run in which every frame shows a state of its own, and the last state is another or is not.
struct PlannedRun
{
    const char* selection;
    std::size_t limit, stride, frames, held;
    bool endsWithNews;

    [[nodiscard]] Scene scene() const
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.frames.selection = selection;
        scene.frames.limit = limit;
        scene.frames.fps = 10;
        scene.frames.hold = static_cast<double>(held) / 10;
        return scene;
    }
    [[nodiscard]] std::uint64_t lastState() const { return frames - (endsWithNews ? 0 : 1); }
    [[nodiscard]] std::string name() const
    {
        return fmt::format("{} of {} frames, held for {}, stride {}, limit {}, {}", selection,
                           frames, held, stride, limit, endsWithNews ? "news" : "no news");
    }
};

/// What is in the folder, and what went by.
struct Folder
{
    std::vector<std::uint64_t> states; ///< that the pictures show
    std::vector<std::size_t> frames;   ///< that were taken
    std::vector<std::size_t> clocks;

    void put(const PicturePlan::Picture& picture, std::uint64_t state)
    {
        frames.push_back(picture.frame);
        clocks.push_back(picture.clock);
        if (picture.index)
        {
            EXPECT_EQ(*picture.index, states.size());
            states.push_back(state);
        }
    }
};

Folder draw(PicturePlan& plan, const PlannedRun& run, std::size_t stopAfter = 1000)
{
    Folder folder;
    for (std::size_t frame = 0; frame < run.frames; ++frame)
    {
        if (plan.wants(frame))
        {
            folder.put(plan.take(frame, frame), frame);
        }
        else
        {
            plan.pass(frame);
        }
    }
    std::size_t asked = 0;
    plan.finish(
        run.frames, run.lastState(), [&] { return asked++ >= stopAfter; },
        [&](const PicturePlan::Picture& picture) { folder.put(picture, run.lastState()); });
    return folder;
}

template <typename Test>
void forEachRun(Test&& test)
{
    for (const char* selection : {"all", "last", "0..5", "2..30:3,last", "1,7", "3..40:2"})
    {
        for (const std::size_t limit : {0U, 1U, 2U, 3U, 7U})
        {
            for (std::size_t shape = 0; shape < 4 * 23 * 4 * 2; ++shape)
            {
                test(PlannedRun{selection, limit, 1 + shape % 4, 1 + shape / 4 % 23, shape / 92 % 4,
                                shape / 368 != 0});
            }
        }
    }
}

TEST(PicturePlan, KeepsEveryNthAndShowsTheLastStateAtTheEnd)
{
    forEachRun(
        [](const PlannedRun& run)
        {
            SCOPED_TRACE(run.name());
            PicturePlan plan(run.scene(), 0);
            plan.keepEvery(run.stride);
            const Folder folder = draw(plan, run);
            ASSERT_EQ(plan.count(), folder.states.size());
            ASSERT_LE(folder.states.size(), (run.frames + run.held) / run.stride + 2);
            ASSERT_TRUE(std::is_sorted(folder.states.begin(), folder.states.end()));
            // The last comes twice if it was not kept as one of them.
            ASSERT_TRUE(std::is_sorted(folder.frames.begin(), folder.frames.end()));
            ASSERT_EQ(folder.clocks, folder.frames);
            if (FrameSelection::parse(run.selection)->hasLast())
            {
                ASSERT_FALSE(folder.states.empty());
                ASSERT_EQ(folder.states.back(), run.lastState());
                // Once, but where it is held.
                ASSERT_LE(std::count(folder.states.begin(), folder.states.end(), run.lastState()),
                          std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(run.held) + 1));
            }
        });
}

TEST(PicturePlan, WithoutALimitTakesEverySelectedFrameInItsPlace)
{
    forEachRun(
        [](const PlannedRun& run)
        {
            if (run.limit != 0 || run.stride != 1)
            {
                return;
            }
            SCOPED_TRACE(run.name());
            const FrameSelection selection = FrameSelection::parse(run.selection).value();
            std::vector<std::size_t> frames;
            std::vector<std::uint64_t> states;
            // The number after the frames is that of the last state.
            const bool isAll = std::string(run.selection) == "all";
            for (std::size_t i = 0; i < run.frames + std::max<std::size_t>(run.held, 1); ++i)
            {
                const bool isLast = run.held == 0 && i == run.frames;
                if (isLast ? !isAll && selection.has(i)
                           : selection.has(i) || (selection.hasLast() && i >= run.frames))
                {
                    frames.push_back(i);
                    states.push_back(i >= run.frames ? run.lastState() : i);
                }
            }
            const std::size_t selected = frames.size();
            if (selection.hasLast() && (states.empty() || states.back() != run.lastState()))
            {
                frames.push_back(run.frames);
                states.push_back(run.lastState());
            }
            PicturePlan plan(run.scene(), 0);
            const Folder folder = draw(plan, run);
            ASSERT_EQ(folder.frames, frames);
            ASSERT_EQ(folder.states, states);

            PicturePlan counted(run.scene(), 0);
            for (std::size_t frame = 0; frame < run.frames; ++frame)
            {
                counted.pass(frame);
            }
            counted.passLast(run.frames);
            ASSERT_EQ(counted.selected(),
                      std::max<std::size_t>(selected, selection.hasLast() ? 1 : 0));
        });
}

// Pictures are chosen alike whether a video gets all frames or none.
TEST(PicturePlan, KeepsTheSamePicturesWhenAVideoGetsEveryFrame)
{
    forEachRun(
        [](const PlannedRun& run)
        {
            SCOPED_TRACE(run.name());
            PicturePlan pictures(run.scene(), 0);
            PicturePlan video(run.scene(), 0, true);
            pictures.keepEvery(run.stride);
            video.keepEvery(run.stride);
            const Folder few = draw(pictures, run);
            const Folder all = draw(video, run);
            ASSERT_EQ(few.states, all.states);
            ASSERT_GE(all.frames.size(), few.frames.size());
            ASSERT_EQ(pictures.keptState(), video.keptState());
        });
}

TEST(PicturePlan, ThatIsStoppedHoldsNoLongerButShowsTheLastState)
{
    const PlannedRun run{"all", 0, 1, 5, 40, true};
    PicturePlan plan(run.scene(), 0);
    EXPECT_EQ(draw(plan, run, 3).frames, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    PicturePlan atOnce(run.scene(), 0);
    EXPECT_EQ(draw(atOnce, run, 0).states, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5}));
    PicturePlan none(PlannedRun{"0..9", 0, 1, 5, 40, true}.scene(), 0);
    EXPECT_EQ(draw(none, run, 0).frames.size(), 5U);
}

// The numbers go on from that of the last state, and the camera begins anew.
TEST(PicturePlan, ShowsTheLastStateForATurnUnlessToldHowLong)
{
    PlannedRun run{"last", 0, 1, 5, 0, true};
    PicturePlan turn(run.scene(), 12);
    const Folder folder = draw(turn, run);
    EXPECT_EQ(folder.states, std::vector<std::uint64_t>(12, 5));
    for (std::size_t i = 0; i < 12; ++i)
    {
        EXPECT_EQ(folder.frames.at(i), 5 + i);
        EXPECT_EQ(folder.clocks.at(i), i);
    }
    run.held = 3;
    PicturePlan held(run.scene(), 12);
    EXPECT_EQ(draw(held, run).frames, (std::vector<std::size_t>{5, 6, 7}));
}

TEST(PicturePlan, TakesTheNumbersOfATurnAsItTakesTheTurn)
{
    PlannedRun run{"5..30:4", 0, 1, 5, 0, true};
    PicturePlan turn(run.scene(), 12);
    const Folder folder = draw(turn, run);
    EXPECT_EQ(folder.frames, (std::vector<std::size_t>{5, 9, 13}));
    EXPECT_EQ(folder.clocks, (std::vector<std::size_t>{0, 4, 8}));
    run.selection = "3..30:4"; // begins before the last state
    PicturePlan film(run.scene(), 12);
    EXPECT_EQ(draw(film, run).frames, (std::vector<std::size_t>{3}));
}

// A run that was killed has no state after that of its last frame.
TEST(PicturePlan, TakesTheLastFrameOfARunThatHasNotEnded)
{
    for (const char* selection : {"last", "4", "3..9", "all"})
    {
        const PlannedRun run{selection, 0, 1, 5, 0, false};
        PicturePlan plan(run.scene(), 0);
        std::vector<std::size_t> frames;
        for (std::size_t frame = 0; frame < 5; ++frame)
        {
            plan.wants(frame) ? frames.push_back(plan.take(frame, frame).frame) : plan.pass(frame);
        }
        plan.finish(4, 4, {},
                    [&](const PicturePlan::Picture& picture) { frames.push_back(picture.frame); });
        ASSERT_FALSE(frames.empty()) << selection;
        EXPECT_EQ(frames.back(), 4U) << selection;
        EXPECT_EQ(std::count(frames.begin(), frames.end(), 4U), 1) << selection;
    }
}

TEST(PicturePlan, WantsTheLastStateOnlyWhereItIsShown)
{
    PicturePlan none(PlannedRun{"0..3", 0, 1, 5, 0, true}.scene(), 0);
    EXPECT_FALSE(none.wantsLast(5));
    PicturePlan named(PlannedRun{"0..5", 0, 1, 5, 0, true}.scene(), 0);
    EXPECT_TRUE(named.wantsLast(5));
    PicturePlan held(PlannedRun{"0..3", 0, 1, 5, 2, true}.scene(), 0);
    EXPECT_TRUE(held.wantsLast(5));
}

} // namespace
} // namespace frostfill

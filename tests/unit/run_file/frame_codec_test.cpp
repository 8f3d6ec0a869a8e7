// SPDX-License-Identifier: MIT
// What the simulation seldom does to its spheres, and falls that are only drawn.
#include "run_file/frame_codec.hpp"

#include "unit/run_file/recorded_run.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <utility>

namespace frostfill
{
namespace
{

/// Writes frames by hand and reads them again.
class FrameCodec : public ::testing::Test
{
protected:
    void addSphere(SphereState state, double radius, std::uint32_t group)
    {
        const auto id = static_cast<float>(snapshot_.centres.size());
        snapshot_.centres.emplace_back(id, 0.5F * id, -id);
        snapshot_.radii.push_back(static_cast<float>(radius));
        snapshot_.states.push_back(state);
        snapshot_.groups.push_back(group);
        snapshot_.speeds.push_back(0);
        radii_.push_back(radius);
    }
    void withdrawLast()
    {
        radii_.pop_back();
        snapshot_.resize(radii_.size());
    }
    void waits(std::size_t id)
    {
        snapshot_.waiting.resize(radii_.size());
        snapshot_.waiting[id] = 1;
    }
    void falls(std::size_t id) { snapshot_.waiting[id] = 0; }
    /// `changed` may name too much, as from snapshots that are filled in turn.
    void put()
    {
        snapshot_.changed.resize(snapshot_.centres.size());
        std::iota(snapshot_.changed.begin(), snapshot_.changed.end(), 0U);
        count();
        encoder_.encode(snapshot_,
                        [&](std::uint32_t id)
                        {
                            SphereRecord sphere;
                            sphere.centre = snapshot_.centres[id].cast<double>();
                            sphere.radius = radii_[id];
                            return sphere;
                        });
        expectTheSame();
    }
    void repeat()
    {
        encoder_.repeat();
        expectTheSame();
    }
    void expectTheSame()
    {
        const std::string bytes = joined(encoder_.take());
        StreamReaders streams = split(bytes);
        decoder_.decode(streams);
        for (const auto& [name, rest] : streams)
        {
            EXPECT_TRUE(rest.done()) << name;
        }
        const Snapshot& read = decoder_.snapshot();
        test::expectSame(read, snapshot_);
        for (std::size_t id = 0; id < radii_.size(); ++id)
        {
            EXPECT_EQ(read.waits(id), snapshot_.waits(id)) << id;
        }
    }

    Snapshot snapshot_;
    std::vector<double> radii_;
    FrameEncoder encoder_{Rounding{gridOf(1)}, Eigen::Vector3d::Zero(), 0};
    FrameDecoder decoder_{gridOf(1), Eigen::Vector3d::Zero(), 0, 1};

private:
    void count()
    {
        const auto of = [&](SphereState state)
        {
            std::size_t n = 0;
            for (std::size_t id = 0; id < radii_.size(); ++id)
            {
                n += snapshot_.states[id] == state && !snapshot_.waits(id) ? 1 : 0;
            }
            return n;
        };
        snapshot_.running = of(SphereState::running);
        snapshot_.frozen = of(SphereState::frozen);
        snapshot_.discarded = of(SphereState::discarded);
    }
};

TEST_F(FrameCodec, KeepsASphereThatIsWithdrawnAndOneThatTakesItsNumber)
{
    addSphere(SphereState::running, 1, 0);
    addSphere(SphereState::frozen, 1.25, 0);
    addSphere(SphereState::running, 1.5, 1);
    put();
    // Number 0 is withdrawn, and the last sphere takes its number.
    radii_[0] = 1.5;
    snapshot_.radii[0] = 1.5;
    snapshot_.groups[0] = 1;
    snapshot_.centres[0] = snapshot_.centres[2];
    withdrawLast();
    put();
    addSphere(SphereState::running, 1, 2);
    addSphere(SphereState::discarded, 1.25, 2);
    put();
    withdrawLast();
    withdrawLast();
    withdrawLast();
    put();
}

TEST_F(FrameCodec, KeepsTheGroupOfASphereThatTakesTheNumberOfOneAsLarge)
{
    addSphere(SphereState::running, 1, 0);
    addSphere(SphereState::running, 1, 4);
    put();
    snapshot_.groups[0] = 4;
    snapshot_.centres[0] = snapshot_.centres[1];
    withdrawLast();
    put();
}

TEST_F(FrameCodec, KeepsSpheresThatWaitForTheirFall)
{
    addSphere(SphereState::running, 1, 0);
    addSphere(SphereState::running, 1.1, 0);
    waits(0);
    waits(1);
    put();
    falls(1);
    put();
    falls(0);
    snapshot_.states[1] = SphereState::frozen;
    put();
    addSphere(SphereState::running, 1.2, 1);
    waits(2);
    put();
    withdrawLast();
    put();
}

TEST_F(FrameCodec, KeepsWhereASphereRestsThatWokeBetweenTwoFrames)
{
    addSphere(SphereState::frozen, 1, 0);
    addSphere(SphereState::running, 1, 0);
    put();
    snapshot_.centres[0].x() += 1e-5F; // a fifth of the grid
    put();
    EXPECT_EQ(decoder_.centres()[0].x(), double{1e-5F});
}

TEST_F(FrameCodec, KeepsSpeedsWhileSpheresRun)
{
    addSphere(SphereState::running, 1, 0);
    addSphere(SphereState::running, 1, 0);
    snapshot_.speeds = {1.5F, 0.25F};
    put();
    snapshot_.states[0] = SphereState::frozen;
    snapshot_.speeds = {0, 64};
    put();
    snapshot_.states[0] = SphereState::running;
    snapshot_.speeds = {0.5F, 64};
    put();
}

TEST_F(FrameCodec, TellsARepeatedStateFromANewOne)
{
    addSphere(SphereState::running, 1, 0);
    put();
    EXPECT_EQ(decoder_.snapshot().revision, 1U);
    repeat();
    EXPECT_EQ(decoder_.snapshot().revision, 1U);
    put();
    EXPECT_EQ(decoder_.snapshot().revision, 2U);
}

// A file can say anything behind sums that are right. With sanitizers this must not overflow.
TEST_F(FrameCodec, WrapsNumbersRoundThatAreTooLarge)
{
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
    static_assert(wrappedSum(kMost, 1) == -kMost - 1 && wrappedDifference(-kMost, 2) == kMost);
    addSphere(SphereState::running, 1, 0);
    put();
    // Its places are then the largest number, 4 less, and 5.
    for (const std::int64_t moved : {kMost, kMost - 2, 13 - kMost})
    {
        Streams streams;
        streams["frames"].count(0);
        for (int fact = 0; fact < 6; ++fact)
        {
            streams["frames"].difference(kMost);
        }
        streams["times"].raw(1.0);
        streams["changes"].count(1);
        for (int list = 0; list < 3; ++list)
        {
            streams["changes"].pass(std::vector<std::uint32_t>(), 0);
        }
        for (const char* axis : {"x", "y", "z"})
        {
            streams[axis].difference(moved);
        }
        streams["speed"].difference(-kMost);
        const std::string bytes = joined(std::move(streams));
        StreamReaders readers = split(bytes);
        decoder_.decode(readers);
    }
    EXPECT_EQ(decoder_.centres()[0].x() / gridOf(1), 5);
}

TEST_F(FrameCodec, GathersChangesUntilTheyAreForgotten)
{
    addSphere(SphereState::running, 1, 0);
    put();
    addSphere(SphereState::frozen, 1, 0);
    put();
    decoder_.sortChanges();
    EXPECT_EQ(decoder_.snapshot().changed, (std::vector<std::uint32_t>{0, 1}));
    decoder_.forgetChanges();
    EXPECT_TRUE(decoder_.snapshot().changed.empty());
    EXPECT_EQ(decoder_.snapshot().changedSince, 2U);
    repeat();
    EXPECT_TRUE(decoder_.snapshot().changed.empty());
}

} // namespace
} // namespace frostfill

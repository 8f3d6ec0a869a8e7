// SPDX-License-Identifier: MIT
// Can everyone read the scale of colours, and does it grow as its numbers do?
#include "render/overlay/colour_scale.hpp"

#include "support/colour_vision.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using namespace testing_support;

constexpr int kSteps = 16;

Eigen::Vector3d seen(const Eigen::Matrix3d& vision, double value)
{
    const Colour colour = scaleColour(value);
    return lab(vision * Eigen::Vector3d(linear(colour[0] / 255.0), linear(colour[1] / 255.0),
                                        linear(colour[2] / 255.0)));
}

TEST(ColourScale, GetsLighterForEveryKindOfColourVision)
{
    for (const Eigen::Matrix3d& vision : visions())
    {
        for (int i = 0; i < kSteps; ++i)
        {
            EXPECT_GT(seen(vision, (i + 1.0) / kSteps)[0], seen(vision, double{1} * i / kSteps)[0])
                << "vision\n"
                << vision << "\nstep " << i;
        }
    }
}

TEST(ColourScale, EqualStepsAreSeenForEveryKindOfColourVision)
{
    for (const Eigen::Matrix3d& vision : visions())
    {
        for (int i = 0; i < kSteps; ++i)
        {
            const double step =
                (seen(vision, (i + 1.0) / kSteps) - seen(vision, double{1} * i / kSteps)).norm();
            EXPECT_GT(step, 3) << "vision\n" << vision << "\nstep " << i;
            EXPECT_LT(step, 20) << "vision\n" << vision << "\nstep " << i;
        }
    }
}

TEST(ColourScale, ValuesBeyondItBecomeItsEnds)
{
    EXPECT_EQ(scaleColour(-3), scaleColour(0));
    EXPECT_EQ(scaleColour(7), scaleColour(1));
    EXPECT_EQ(scaleColour(std::nan("")), scaleColour(0));
}

TEST(ColourScale, IsLabelledWithRoundNumbers)
{
    EXPECT_EQ(roundUp(0.037), 0.04);
    EXPECT_EQ(roundUp(5), 5);
    EXPECT_EQ(roundUp(91), 100);
    EXPECT_EQ(roundUp(0), 1);
    EXPECT_EQ(roundNumbers({0, 6}, false), (std::vector<double>{0, 2, 4, 6}));
    EXPECT_EQ(roundNumbers({0, 2.8}, false), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(roundNumbers({0, 31}, true), (std::vector<double>{0, 20}));
    EXPECT_EQ(roundNumbers({0, 1}, true), (std::vector<double>{0, 1}));
    EXPECT_EQ(roundNumbers({3, 3}, true), (std::vector<double>{3}));
}

TEST(ColourScale, OfSpeedsIsForWhatRunsAndCoversTheSpeedsThatAreSeen)
{
    RenderSettings settings;
    settings.style.colourBy = "speed";
    settings.range = {0, 6.2}; // of a fall through the object
    const SphereColours colours(settings, {});
    EXPECT_EQ(colours.range().high, 6);
    Snapshot snapshot;
    for (const SphereState state :
         {SphereState::running, SphereState::frozen, SphereState::discarded})
    {
        snapshot.states.push_back(state);
        snapshot.speeds.push_back(3);
    }
    EXPECT_EQ(colours.of(snapshot, 0), scaleColour(0.5));
    for (const std::size_t atRest : {1U, 2U})
    {
        const Colour grey = colours.of(snapshot, atRest);
        EXPECT_LT(*std::max_element(grey.begin(), grey.begin() + 3) -
                      *std::min_element(grey.begin(), grey.begin() + 3),
                  15);
        EXPECT_EQ(grey, colours.ofSwatch(snapshot.states[atRest]));
    }
}

} // namespace
} // namespace frostfill

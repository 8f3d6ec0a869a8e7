// SPDX-License-Identifier: MIT
// Can everyone read the scale of colours, and does it grow as its numbers do?
#include "render/overlay/colour_scale.hpp"

#include "support/colour_vision.hpp"

#include <gtest/gtest.h>

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

} // namespace
} // namespace frostfill

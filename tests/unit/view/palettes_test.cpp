// SPDX-License-Identifier: MIT
// Can everyone tell the states apart and read the text, in the colours of each look?
#include "support/colour_vision.hpp"

#include <frostfill/view.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using namespace testing_support;

constexpr std::array kLooks = {Look::clean, Look::paper, Look::dark, Look::studio};

Eigen::Vector3d linearOf(const Colour& colour)
{
    return {linear(colour[0] / 255.0), linear(colour[1] / 255.0), linear(colour[2] / 255.0)};
}

/// Difference of two colours in CIELAB, to the eyes that see the least of it.
double leastDifference(const Colour& a, const Colour& b)
{
    double least = 1e9;
    for (const Eigen::Matrix3d& vision : visions())
    {
        least = std::min(least, (lab(vision * linearOf(a)) - lab(vision * linearOf(b))).norm());
    }
    return least;
}

double luminance(const Colour& colour)
{
    return Eigen::Vector3d(0.2126, 0.7152, 0.0722).dot(linearOf(colour));
}

/// As the guidelines for accessible web pages define it (WCAG 2.2).
double contrast(const Colour& a, const Colour& b)
{
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

TEST(Palettes, TellStatesApartForEveryKindOfColourVision)
{
    for (const Look look : kLooks)
    {
        const Palette palette = paletteOf(look);
        EXPECT_GT(leastDifference(palette.running, palette.frozen), 40) << int(look);
        EXPECT_GT(leastDifference(palette.running, palette.discarded), 20) << int(look);
        EXPECT_GT(leastDifference(palette.frozen, palette.discarded), 20) << int(look);
        for (const Colour& sphere : {palette.running, palette.frozen, palette.discarded})
        {
            EXPECT_GT(leastDifference(sphere, palette.background), 10) << int(look);
        }
    }
}

// Pages, documentation and legends speak of orange and blue.
TEST(Palettes, HaveOrangeForWhatRunsAndBlueForWhatIsFrozen)
{
    for (const Look look : kLooks)
    {
        const auto [running, frozen] = std::pair(paletteOf(look).running, paletteOf(look).frozen);
        EXPECT_TRUE(running[0] > running[1] && running[1] > running[2]) << int(look);
        EXPECT_TRUE(frozen[2] > frozen[1] && frozen[1] > frozen[0]) << int(look);
    }
}

TEST(Palettes, HaveTextOfSevenTimesTheContrast)
{
    for (const Look look : kLooks)
    {
        EXPECT_GT(contrast(paletteOf(look).text, paletteOf(look).background), 7) << int(look);
    }
}

TEST(Palettes, LetMostOfTheLightThroughTheShell)
{
    for (const Look look : kLooks)
    {
        EXPECT_LT(paletteOf(look).activePolygon[3], 64) << int(look);
        EXPECT_LT(paletteOf(look).discardedPolygon[3], 128) << int(look);
    }
}

TEST(Palettes, AreThoseOfTheirLooks)
{
    EXPECT_EQ(paletteOf(Look::clean).background, (Colour{255, 255, 255, 255}));
    EXPECT_EQ(paletteOf(Look::clean).running, Palette().running);
    EXPECT_EQ(paletteOf(Look::paper).background, (Colour{255, 255, 255, 255}));
    EXPECT_EQ(paletteOf(Look::paper).text, (Colour{0, 0, 0, 255})); // print has no grey ink
    EXPECT_LT(luminance(paletteOf(Look::dark).background), 0.02);
    // The studio's lamp lights what is white by more than white.
    EXPECT_LT(luminance(paletteOf(Look::studio).background), 0.95);
    EXPECT_GT(luminance(paletteOf(Look::studio).background), 0.85);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "render/overlay/text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace frostfill
{
namespace
{

constexpr Colour kBlack = {0, 0, 0, 255};
constexpr Colour kWhite = {255, 255, 255, 255};

Image whitePicture(int width, int height)
{
    return {width, height, 3,
            std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 3), 255)};
}

TEST(Font, WidthGrowsWithTextAndSize)
{
    const Font small(10);
    const Font large(20);
    EXPECT_EQ(small.measure(""), 0);
    EXPECT_GT(small.measure("frozen 10"), small.measure("frozen"));
    EXPECT_NEAR(large.measure("frozen"), 2 * small.measure("frozen"), 0.01);
}

TEST(Font, DigitsAreOfOneWidthSoThatNumbersDoNotJump)
{
    const Font font(17);
    EXPECT_EQ(font.measure("1111"), font.measure("8888"));
}

TEST(Font, LettersOfManyBytesAreOneLetter)
{
    const Font font(20);
    EXPECT_NEAR(font.measure("\u00fc"), font.measure("u"), 1);
    // What is not UTF-8 is shown as such and does no harm.
    EXPECT_GT(font.measure("\xff\xc3"), 0);
}

TEST(Font, LongTextIsShortenedToFit)
{
    const Font font(20);
    EXPECT_EQ(font.shorten("torus", 500), "torus");
    const std::string shortened = font.shorten("a torus with a very long description", 150);
    EXPECT_LE(font.measure(shortened), 150);
    EXPECT_TRUE(shortened.starts_with("a torus"));
    EXPECT_TRUE(shortened.ends_with("\u2026"));
}

TEST(Font, DrawsInkOnlyWhereTheTextIs)
{
    const Font font(20);
    Image image = whitePicture(200, 40);
    font.draw(image, 10, 30, "Frostfill", kBlack, kWhite);
    const auto right = static_cast<int>(10 + font.measure("Frostfill"));
    std::size_t dark = 0;
    for (int y = 0; y < 40; ++y)
    {
        for (int x = 0; x < 200; ++x)
        {
            const bool ink = image.at(x, y)[0] < 255;
            dark += image.at(x, y)[0] < 60 ? 1 : 0;
            EXPECT_FALSE(ink && (x < 9 || x > right + 1 || y < 10 || y > 36)) << x << ' ' << y;
        }
    }
    EXPECT_GT(dark, 150U);
}

TEST(Font, BoundsHoldTheTextWithItsHaloAndNothingElse)
{
    const Font font(20);
    Image image = whitePicture(200, 40);
    // On black a white halo shows too.
    std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{0});
    font.draw(image, 10.3, 30, " (Frostfill)", kBlack, kWhite);
    std::array<int, 4> drawn = {200, 40, 0, 0};
    for (int y = 0; y < 40; ++y)
    {
        for (int x = 0; x < 200; ++x)
        {
            if (image.at(x, y)[0] != 0)
            {
                drawn = {std::min(drawn[0], x), std::min(drawn[1], y), std::max(drawn[2], x + 1),
                         std::max(drawn[3], y + 1)};
            }
        }
    }
    EXPECT_EQ(font.bounds(10.3, 30, " (Frostfill)"), drawn);
    EXPECT_EQ(font.bounds(10.3, 30, "  "), (std::array<int, 4>{}));
}

TEST(Font, TextThatLeavesThePictureIsCutOff)
{
    const Font font(30);
    Image image = whitePicture(20, 10);
    for (const double x : {-50.0, -5.0, 15.0, 100.0})
    {
        font.draw(image, x, 12, "Wide", kBlack, kWhite);
        font.draw(image, x, -20, "Wide", kBlack, kWhite);
    }
    EXPECT_EQ(image.pixels.size(), 20U * 10U * 3U);
}

} // namespace
} // namespace frostfill

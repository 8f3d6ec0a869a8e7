// SPDX-License-Identifier: MIT
#include <frostfill/image.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

Image plain(int width, int height, int channels, std::uint8_t value)
{
    return {width, height, channels,
            std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * channels), value)};
}

TEST(CompareImages, EqualPicturesDoNotDiffer)
{
    const ImageDifference difference = compareImages(plain(5, 4, 3, 9), plain(5, 4, 3, 9));
    EXPECT_TRUE(difference.sameShape);
    EXPECT_EQ(difference.rootMeanSquare, 0);
    EXPECT_EQ(difference.largest, 0);
    EXPECT_EQ(difference.pixelsApart, 0U);
}

TEST(CompareImages, OneChannelOfOnePixelCountsByItsShareOfAllChannels)
{
    const Image a = plain(5, 4, 3, 100);
    Image b = a;
    b.pixels[7] = 112;
    const ImageDifference difference = compareImages(a, b);
    EXPECT_DOUBLE_EQ(difference.rootMeanSquare, std::sqrt(12.0 * 12.0 / 60.0));
    EXPECT_EQ(difference.largest, 12);
    EXPECT_EQ(difference.pixelsApart, 1U);
}

TEST(CompareImages, DifferenceOfEightIsNotYetApart)
{
    EXPECT_EQ(compareImages(plain(3, 3, 4, 100), plain(3, 3, 4, 108)).pixelsApart, 0U);
    EXPECT_EQ(compareImages(plain(3, 3, 4, 100), plain(3, 3, 4, 91)).pixelsApart, 9U);
}

TEST(CompareImages, BlackAndWhiteDifferByAll)
{
    const ImageDifference difference = compareImages(plain(2, 2, 3, 0), plain(2, 2, 3, 255));
    EXPECT_EQ(difference.rootMeanSquare, 255);
    EXPECT_EQ(difference.largest, 255);
}

TEST(CompareImages, OtherShapeIsReportedAndNothingElse)
{
    for (const Image& other : {plain(4, 5, 3, 1), plain(5, 5, 3, 1), plain(5, 4, 4, 1)})
    {
        const ImageDifference difference = compareImages(plain(5, 4, 3, 0), other);
        EXPECT_FALSE(difference.sameShape);
        EXPECT_EQ(difference.largest, 0);
    }
}

} // namespace
} // namespace frostfill

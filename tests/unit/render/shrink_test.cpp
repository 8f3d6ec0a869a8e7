// SPDX-License-Identifier: MIT
#include "render/annotated_picture.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

Image noise(int width, int height, int channels)
{
    Image image;
    image.width = width;
    image.height = height;
    image.channels = channels;
    testing_support::Numbers numbers;
    for (int i = 0; i < width * height * channels; ++i)
    {
        // Some are clear altogether.
        const double value = numbers.next();
        image.pixels.push_back(
            static_cast<std::uint8_t>(i % 4 == 3 && value < 0.3 ? 0 : 255.99 * value));
    }
    return image;
}

TEST(Shrunk, HasTheMeanOfEachSquareRoundedToTheNearest)
{
    const Image large = noise(12, 9, 3);
    const Image small = shrunk(large, 3);
    ASSERT_EQ(small.width, 4);
    ASSERT_EQ(small.height, 3);
    for (int y = 0; y < small.height; ++y)
    {
        for (int x = 0; x < small.width; ++x)
        {
            for (int c = 0; c < 3; ++c)
            {
                double sum = 0;
                for (int i = 0; i < 9; ++i)
                {
                    sum += large.at(3 * x + i % 3, 3 * y + i / 3)[c];
                }
                EXPECT_EQ(small.at(x, y)[c], std::lround(sum / 9));
            }
        }
    }
}

TEST(Shrunk, CountsColoursByHowOpaqueTheyAre)
{
    const Image large = noise(12, 8, 4);
    const Image small = shrunk(large, 2);
    ASSERT_EQ(small.channels, 4);
    for (int y = 0; y < small.height; ++y)
    {
        for (int x = 0; x < small.width; ++x)
        {
            double alpha = 0;
            Eigen::Vector3d colour = Eigen::Vector3d::Zero();
            for (int i = 0; i < 4; ++i)
            {
                const std::uint8_t* pixel = large.at(2 * x + i % 2, 2 * y + i / 2);
                alpha += pixel[3];
                colour += double{1} * pixel[3] * Eigen::Vector3d(pixel[0], pixel[1], pixel[2]);
            }
            EXPECT_NEAR(small.at(x, y)[3], alpha / 4, 0.5);
            for (int c = 0; c < 3; ++c)
            {
                EXPECT_NEAR(small.at(x, y)[c], alpha > 0 ? colour[c] / alpha : 0, 0.5);
            }
        }
    }
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "run/frame_writer.hpp"

#include "support/load_png.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/image.hpp>

#include <gtest/gtest.h>

#include <random>

namespace frostfill
{
namespace
{

/// Changes some rows, and says which.
std::vector<std::uint8_t> changeRows(Image& image, std::mt19937& random)
{
    std::vector<std::uint8_t> changed(static_cast<std::size_t>(image.height));
    const std::size_t row = image.pixels.size() / changed.size();
    for (std::size_t y = 0; y < changed.size(); ++y)
    {
        changed[y] = random() % 5 == 0 ? 1 : 0;
        for (std::size_t x = 0; changed[y] != 0 && x < row; ++x)
        {
            image.pixels[y * row + x] = static_cast<std::uint8_t>(random());
        }
    }
    return changed;
}

// Of each picture only some rows are copied, in turn into three copies: every file has all of them.
TEST(FrameWriter, WritesEveryRowOfEveryPicture)
{
    const test::TemporaryFolder folder;
    std::mt19937 random(26);
    Image image{16, 40, 3, std::vector<std::uint8_t>(16 * 40 * 3, 7)};
    std::vector<Image> wanted;
    FrameWriter writer(folder.path(), {{"Software", "Frostfill"}});
    for (std::size_t number = 0; number < 30; ++number)
    {
        std::vector<std::uint8_t> changed(40, number == 0 ? 1 : 0);
        if (number % 7 != 3) // otherwise the same picture once more
        {
            const std::vector<std::uint8_t> rows = changeRows(image, random);
            changed = number == 0 ? changed : rows;
        }
        writer.put(number, image, changed, number / 10, {});
        wanted.push_back(image);
    }
    writer.finish();
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        EXPECT_EQ(loadPng(folder / PngSequence::fileName(i)).pixels, wanted[i].pixels) << i;
    }
    ASSERT_EQ(writer.milliseconds().size(), 3U);
    EXPECT_EQ(writer.milliseconds()[1].size(), 10U);
}

} // namespace
} // namespace frostfill

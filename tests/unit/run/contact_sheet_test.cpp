// SPDX-License-Identifier: MIT
#include "run/contact_sheet.hpp"

#include "support/temporary_folder.hpp"

#include <frostfill/output.hpp>

#include <gtest/gtest.h>

#include <set>

namespace frostfill
{
namespace
{

/// Frames of one colour each: red tells the number, and the left half, to be cropped, is green.
std::vector<std::size_t> writeFrames(const std::filesystem::path& folder, std::size_t count)
{
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < count; ++i)
    {
        numbers.push_back(60 + 2 * i);
        Image image;
        image.width = 80;
        image.height = 30;
        for (int p = 0; p < 80 * 30; ++p)
        {
            const bool left = p % 80 < 40;
            image.pixels.insert(image.pixels.end(), {static_cast<std::uint8_t>(left ? 0 : 100 + i),
                                                     static_cast<std::uint8_t>(left ? 250 : 0), 0});
        }
        savePng(image, folder / PngSequence::fileName(numbers.back()));
    }
    return numbers;
}

std::set<int> redsOn(const Image& sheet)
{
    std::set<int> reds;
    for (std::size_t i = 0; i < sheet.pixels.size(); i += 3)
    {
        EXPECT_FALSE(sheet.pixels[i] < 20 && sheet.pixels[i + 1] > 240) << "what is cropped shows";
        if (sheet.pixels[i] >= 100 && sheet.pixels[i + 1] == 0 && sheet.pixels[i + 2] == 0)
        {
            reds.insert(sheet.pixels[i] - 100);
        }
    }
    return reds;
}

TEST(ContactSheet, ShowsTwelveFramesWithTheFirstAndTheLast)
{
    const test::TemporaryFolder folder;
    ContactSheetRequest request;
    request.numbers = writeFrames(folder.path(), 45);
    request.frames = folder.path();
    request.title = "run";
    request.crop = {40, 0, 80, 30};
    const std::set<int> reds = redsOn(makeContactSheet(request));
    EXPECT_EQ(reds, (std::set<int>{0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44}));
}

TEST(ContactSheet, ShowsAllOfAFewAndNothingOfNone)
{
    const test::TemporaryFolder folder;
    ContactSheetRequest request;
    request.frames = folder.path();
    request.crop = {40, 0, 80, 30};
    for (const std::size_t count : {0U, 1U, 3U})
    {
        request.numbers = writeFrames(folder.path(), count);
        EXPECT_EQ(redsOn(makeContactSheet(request)).size(), count);
    }
}

} // namespace
} // namespace frostfill

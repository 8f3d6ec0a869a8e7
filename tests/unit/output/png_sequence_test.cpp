// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/load_png.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/output.hpp>

#include <fmt/format.h>

#include <set>

namespace frostfill
{
namespace
{

/// One pixel that tells the number it was made from.
Image numberedImage(std::size_t number)
{
    return {1, 1, 3, {static_cast<std::uint8_t>(number), 0, 0}};
}

std::size_t numberOf(const std::filesystem::path& file)
{
    return loadPng(file).pixels.at(0);
}

TEST(PngSequence, NamesPicturesByTheNumbersOfTheirFrames)
{
    const test::TemporaryFolder folder;
    PngSequence sequence(folder / "frames");
    std::set<std::string> names;
    for (const std::size_t number : {0U, 7U, 60U, 255U})
    {
        sequence.put(number, numberedImage(number));
        EXPECT_EQ(numberOf(folder / fmt::format("frames/frame_{:05}.png", number)), number);
    }
    EXPECT_EQ(PngSequence::fileName(123456), "frame_123456.png");
    EXPECT_EQ(numberedName("spheres", 42, "vtp"), "spheres_00042.vtp");
}

TEST(PngSequence, KnowsItsOwnNames)
{
    EXPECT_EQ(PngSequence::endingOf(PngSequence::fileName(0)), ".png");
    EXPECT_EQ(PngSequence::endingOf(PngSequence::fileName(1234567)), ".png");
    EXPECT_EQ(PngSequence::endingOf("frame_00012.png.4711.tmp"), ".png.4711.tmp");
    for (const char* other : {"", "frame", "frame_", "frame_1.png", "frame_0001.png",
                              "frames_00001", "spheres_00042.vtp", "frame_x0001.png"})
    {
        EXPECT_EQ(PngSequence::endingOf(other), "") << other;
    }
}

TEST(PngSequence, TellsThatItsDirectoryCannotBeCreated)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder / "file", "");
    test::expectError(
        ErrorCode::cannotCreate, [&] { PngSequence sequence(folder / "file"); }, "file");
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
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

TEST(PngSequence, NumbersPicturesFromZero)
{
    const test::TemporaryFolder folder;
    PngSequence sequence(folder / "frames", 0);
    for (std::size_t i = 0; i < 3; ++i)
    {
        sequence.put(i, numberedImage(i));
    }
    EXPECT_EQ(sequence.count(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
    {
        EXPECT_EQ(numberOf(folder / fmt::format("frames/frame_{:05}.png", i)), i);
    }
}

TEST(PngSequence, KeepsEveryNthWhenThereAreTooMany)
{
    for (const std::size_t limit : {1u, 2u, 3u, 5u, 8u})
    {
        for (const std::size_t total : {1u, 2u, 5u, 9u, 33u, 100u})
        {
            const test::TemporaryFolder folder;
            PngSequence sequence(folder.path(), limit);
            for (std::size_t i = 0; i < total; ++i)
            {
                sequence.put(i, numberedImage(i));
            }

            EXPECT_LE(sequence.count(), limit);
            EXPECT_TRUE(sequence.count() == limit || limit == 1 || 2 * sequence.count() >= limit ||
                        sequence.count() == total)
                << limit << " of " << total;
            std::set<std::string> names;
            for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            {
                names.insert(entry.path().filename());
            }
            EXPECT_EQ(names.size(), sequence.count());
            for (std::size_t i = 0; i < sequence.count(); ++i)
            {
                EXPECT_EQ(numberOf(folder / fmt::format("frame_{:05}.png", i)),
                          i * sequence.stride());
            }
        }
    }
}

// Picture 3 falls to thinning, and 4, which is kept, does not differ from it.
TEST(PngSequence, PicturesThatAreNotKeptLeaveTheirChangesToTheNext)
{
    const test::TemporaryFolder folder;
    PngSequence sequence(folder.path(), 2);
    const std::vector<std::uint8_t> changed = {1};
    const std::vector<std::uint8_t> same = {0};
    for (std::size_t i = 0; i < 4; ++i)
    {
        sequence.put(i, numberedImage(i), changed, {});
    }
    sequence.put(4, numberedImage(3), same, {});
    EXPECT_EQ(sequence.stride(), 4u);
    EXPECT_EQ(numberOf(folder / "frame_00001.png"), 3u);
}

TEST(PngSequence, ThinningLeavesOtherFilesWhereTheyAre)
{
    const test::TemporaryFolder folder;
    PngSequence sequence(folder / "frames", 4);
    test::writeFile(folder / "frames/notes.txt", "mine");
    std::filesystem::create_directory(folder / "frames/more");
    for (std::size_t i = 0; i < 9; ++i)
    {
        sequence.put(i, numberedImage(i));
    }
    EXPECT_EQ(sequence.count(), 3u);
    EXPECT_EQ(test::readFile(folder / "frames/notes.txt"), "mine");
    EXPECT_TRUE(std::filesystem::is_directory(folder / "frames/more"));
    EXPECT_FALSE(std::filesystem::exists(folder / "frames.part"));
}

TEST(PngSequence, ThinsThroughASymbolicLinkWithoutReplacingIt)
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder / "elsewhere");
    std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "frames");
    PngSequence sequence(folder / "frames", 2);
    for (std::size_t i = 0; i < 5; ++i)
    {
        sequence.put(i, numberedImage(i));
    }
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "frames"));
    EXPECT_EQ(numberOf(folder / "elsewhere/frame_00001.png"), sequence.stride());
}

TEST(PngSequence, TellsThatItsDirectoryCannotBeCreated)
{
    const test::TemporaryFolder folder;
    test::writeFile(folder / "file", "");
    test::expectError(
        ErrorCode::cannotCreate, [&] { PngSequence sequence(folder / "file", 0); }, "file");
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "run/run_directory.hpp"

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace frostfill
{
namespace
{

using test::expectError;
using test::TemporaryFolder;
using test::writeFile;

TEST(RunDirectory, IsCreatedWithWhatIsMissingAboveIt)
{
    const TemporaryFolder folder;
    prepareRunDirectory(folder / "a/b", false);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "a/b"));
    prepareRunDirectory(folder / "a/b", false);
}

TEST(RunDirectory, IsRefusedWhenItHoldsARun)
{
    const TemporaryFolder folder;
    writeFile(folder / "spheres.csv", "");
    expectError(
        ErrorCode::cannotCreate, [&] { prepareRunDirectory(folder.path(), false); }, "--overwrite",
        folder.path().string());
    EXPECT_TRUE(std::filesystem::exists(folder / "spheres.csv"));
}

TEST(RunDirectory, LosesTheFilesOfARunAndNothingElseWhenOverwritten)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "frames");
    for (const char* name : {"spheres.csv", "polygons.csv", "sets.csv", "summary.json", "mesh.ply",
                             "frames/frame_00000.png", "frames/frame_00001.png.part"})
    {
        writeFile(folder / name, "old");
    }
    writeFile(folder / "notes.txt", "mine");
    writeFile(folder / "frames/frame.txt", "mine");

    prepareRunDirectory(folder.path(), true);
    std::size_t left = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    {
        left += entry.is_regular_file() ? 1 : 0;
    }
    EXPECT_EQ(left, 2u);
    EXPECT_EQ(test::readFile(folder / "notes.txt"), "mine");
    EXPECT_EQ(test::readFile(folder / "frames/frame.txt"), "mine");
}

TEST(RunDirectory, IsRefusedWhenAFileIsInTheWay)
{
    const TemporaryFolder folder;
    writeFile(folder / "file", "");
    expectError(
        ErrorCode::cannotCreate, [&] { prepareRunDirectory(folder / "file", true); }, "file");
}

} // namespace
} // namespace frostfill

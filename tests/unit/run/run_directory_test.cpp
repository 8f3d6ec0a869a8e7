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

/// What stands in the files of a run.
void writeOldRun(const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder / "frames");
    writeFile(folder / "spheres.csv", "id,group,x,y,z,radius,state\n");
    writeFile(folder / "polygons.csv", "id,state\n");
    writeFile(folder / "sets.csv", "set,spheres,frames\n");
    writeFile(folder / "summary.json", "{\n  \"outcome\": \"full\"}");
    writeFile(folder / "mesh.ply", "ply\ncomment Frostfill\n");
    writeFile(folder / "run.frost", "frostrun\x01");
    writeFile(folder / "frames/frame_00000.png", "\x89PNG tEXtSoftware Frostfill");
}

std::size_t countFiles(const std::filesystem::path& folder)
{
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        count += entry.is_regular_file() ? 1 : 0;
    }
    return count;
}

TEST(RunDirectory, IsCreatedWithWhatIsMissingAboveIt)
{
    const TemporaryFolder folder;
    {
        RunDirectory directory(folder / "a/b", EarlierRun::refuse);
        directory.begin();
        EXPECT_TRUE(std::filesystem::is_empty(folder / "a/b"));
    }
    const RunDirectory again(folder / "a/b", EarlierRun::refuse);
}

TEST(RunDirectory, IsRefusedWhenItHoldsARun)
{
    const TemporaryFolder folder;
    writeOldRun(folder.path());
    expectError(
        ErrorCode::cannotCreate,
        [&] { const RunDirectory directory(folder.path(), EarlierRun::refuse); }, "--overwrite",
        folder.path().string());
    EXPECT_EQ(countFiles(folder.path()), 7u);
}

TEST(RunDirectory, KeepsTheOldRunUntilTheNewOneBegins)
{
    const TemporaryFolder folder;
    writeOldRun(folder.path());
    {
        const RunDirectory directory(folder.path(),
                                     EarlierRun::replace); // and then something else fails
    }
    EXPECT_EQ(countFiles(folder.path()), 7u);
    RunDirectory directory(folder.path(), EarlierRun::replace);
    directory.begin();
    EXPECT_EQ(countFiles(folder.path()), 0u);
}

TEST(RunDirectory, KeepsARunThatIsResumedButForItsSummary)
{
    const TemporaryFolder folder;
    writeOldRun(folder.path());
    writeFile(folder / "frames/frame_00012.png.4711.tmp", "\x89P");
    RunDirectory directory(folder.path(), EarlierRun::keep);
    directory.begin();
    EXPECT_EQ(countFiles(folder.path()), 6u);
    EXPECT_FALSE(std::filesystem::exists(folder / "summary.json"));
    EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_00012.png.4711.tmp"));
}

TEST(RunDirectory, TouchesNoFileThatNoRunHasWritten)
{
    const TemporaryFolder folder;
    writeOldRun(folder.path());
    for (const char* mine : {"notes.txt", "frames/frame.txt", "frames/frame_holiday.png",
                             "frames/frame_1.png", "frames/frame_00000.jpg"})
    {
        writeFile(folder / mine, "mine");
    }
    {
        RunDirectory directory(folder.path(), EarlierRun::replace);
        directory.begin();
    }
    EXPECT_EQ(countFiles(folder.path()), 5u);
}

TEST(RunDirectory, RefusesFilesOfOthersUnderItsOwnNames)
{
    const TemporaryFolder folder;
    for (const char* mine :
         {"spheres.csv", "summary.json", "mesh.ply", "run.frost", "frames/frame_00007.png"})
    {
        std::filesystem::create_directory(folder / "frames");
        writeFile(folder / mine, "mine");
        expectError(
            ErrorCode::cannotCreate,
            [&] { const RunDirectory directory(folder.path(), EarlierRun::replace); }, mine,
            "was not written by a run");
        EXPECT_EQ(test::readFile(folder / mine), "mine");
        std::filesystem::remove(folder / mine);
    }
}

TEST(RunDirectory, FollowsNoSymbolicLink)
{
    const TemporaryFolder folder;
    writeOldRun(folder / "elsewhere");
    std::filesystem::create_directory(folder / "run");
    std::filesystem::create_directory_symlink(folder / "elsewhere/frames", folder / "run/frames");
    expectError(
        ErrorCode::cannotCreate,
        [&] { const RunDirectory directory(folder / "run", EarlierRun::replace); },
        "frames is in the way");
    std::filesystem::remove(folder / "run/frames");
    std::filesystem::create_symlink(folder / "elsewhere/mesh.ply", folder / "run/mesh.ply");
    expectError(
        ErrorCode::cannotCreate,
        [&] { const RunDirectory directory(folder / "run", EarlierRun::replace); }, "mesh.ply");
    EXPECT_EQ(countFiles(folder / "elsewhere"), 7u);
}

TEST(RunDirectory, ClearsAwayWhatAKilledRunHasLeft)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "frames");
    writeFile(folder / "sets.csv.part", "se");
    writeFile(folder / "run.frost.part", "fro");
    writeFile(folder / "frames/frame_00012.png.4711.tmp", "\x89P");
    writeFile(folder / "states.frost", "frostrun");
    RunDirectory directory(folder.path(), EarlierRun::refuse); // that is no run
    directory.begin();
    EXPECT_EQ(countFiles(folder.path()), 0u);
}

TEST(RunDirectory, IsRefusedWhileAnotherRunWritesToIt)
{
    const TemporaryFolder folder;
    {
        const RunDirectory first(folder.path(), EarlierRun::refuse);
        expectError(
            ErrorCode::cannotCreate,
            [&] { const RunDirectory second(folder.path(), EarlierRun::replace); },
            "another run is writing to", folder.path().string());
    }
    const RunDirectory third(folder.path(), EarlierRun::refuse);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(RunDirectory, IsRefusedWhenAFileIsInTheWay)
{
    const TemporaryFolder folder;
    writeFile(folder / "file", "");
    expectError(
        ErrorCode::cannotCreate,
        [&] { const RunDirectory directory(folder / "file", EarlierRun::replace); }, "file");
}

} // namespace
} // namespace frostfill

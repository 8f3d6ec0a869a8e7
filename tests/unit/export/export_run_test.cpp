// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "unit/export/exported_run.hpp"

#include <frostfill/fill.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;
using test::readFile;
using test::writeFile;

class ExportRun : public ::testing::Test
{
protected:
    ExportRun() : run_(test::recordRun(test::fewSpheres(), folder_ / "run.frost", 20)) {}
    [[nodiscard]] ExportRequest request(ExportFormat format, const std::string& frames = "") const
    {
        return {.run = folder_.path(),
                .format = format,
                .frames = frames,
                .out = folder_ / "export",
                .overwrite = false};
    }
    test::TemporaryFolder folder_;
    test::RecordedRun run_;
};

TEST_F(ExportRun, WritesTheFramesThatAreSelectedAndNamesTheFileToOpenFirst)
{
    const ExportResult all = exportRun(request(ExportFormat::vtp));
    EXPECT_EQ(all.frames, run_.numbers.size());
    EXPECT_EQ(all.spheres, 40U);
    EXPECT_FALSE(all.unfinished);
    EXPECT_EQ(all.files.front().filename(), "run.pvd");
    std::uintmax_t bytes = 0;
    for (const auto& file : all.files)
    {
        bytes += std::filesystem::file_size(file);
    }
    EXPECT_EQ(all.bytes, bytes);
    const auto inFolder =
        std::distance(std::filesystem::directory_iterator(folder_ / "export"), {});
    EXPECT_EQ(static_cast<std::size_t>(inFolder), all.files.size());

    const ExportResult some = exportRun(request(ExportFormat::csv, "0..8:4,last"));
    ASSERT_EQ(some.frames, 4U);
    EXPECT_EQ(some.files[0].filename(), "spheres_00000.csv");
    EXPECT_EQ(some.files[1].filename(), "spheres_00004.csv");
    EXPECT_EQ(some.files[2].filename(), "spheres_00008.csv");
}

/// The numbers in a file that stand behind a word.
std::vector<double> numbersBehind(const std::string& word, const std::filesystem::path& file)
{
    const std::string text = readFile(file);
    std::vector<double> numbers;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    {
        numbers.push_back(std::stod(text.substr(at + word.size(), 30)));
    }
    return numbers;
}

// A step of the simulation is longer than the time between the frames of so slow a video, and the
// file of a run that has ended has its last state once more.
TEST(ExportOfASlowRun, HasEachMomentOnceSoThatTimesAscend)
{
    const test::TemporaryFolder folder;
    FillRequest request;
    request.scene = test::fewSpheres();
    request.scene.spheres.count = 8;
    request.scene.frames.enabled = false;
    request.scene.frames.keepRun = true;
    request.scene.frames.slowMotion = 40;
    request.directory = folder / "run";
    const FillResult run = fill(request);
    RunFileReader reader(folder / "run/run.frost");
    const auto write = [&](ExportFormat format)
    {
        return exportRun(
            {.run = folder / "run", .format = format, .frames = "all", .out = folder / "export"});
    };

    const ExportResult vtp = write(ExportFormat::vtp);
    EXPECT_GT(vtp.repeats, 0U);
    EXPECT_EQ(vtp.frames + vtp.repeats, reader.frames().size());
    std::vector<double> times = numbersBehind("timestep=\"", folder / "export/run.pvd");
    ASSERT_EQ(times.size(), 2 * vtp.frames); // spheres and mesh
    for (std::size_t i = 2; i < times.size(); ++i)
    {
        EXPECT_LT(times[i - 2], times[i]) << i;
    }
    EXPECT_EQ(times.back(), reader.seek(reader.frames().size() - 1).time);

    const ExportResult xyz = write(ExportFormat::xyz);
    times = numbersBehind(" Time=", folder / "export/spheres.xyz");
    EXPECT_EQ(times.size(), xyz.frames);
    EXPECT_EQ(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()), times.end());
    EXPECT_EQ(write(ExportFormat::npz).frames, vtp.frames);
    EXPECT_EQ(run.spheres, 8U);
}

TEST_F(ExportRun, ReplacesNothingUnasked)
{
    exportRun(request(ExportFormat::csv));
    const auto file =
        folder_ / "export" / exportRun(request(ExportFormat::xyz)).files[0].filename();
    writeFile(file, "mine");
    ExportRequest again = request(ExportFormat::xyz);
    expectError(
        ErrorCode::cannotCreate, [&] { exportRun(again); }, "spheres.xyz", "--overwrite", "--out");
    EXPECT_EQ(readFile(file), "mine");
    again.overwrite = true;
    exportRun(again);
    EXPECT_NE(readFile(file), "mine");
}

TEST_F(ExportRun, OfAnInputReplacesNoneOfItsFilesUnasked)
{
    std::filesystem::create_directory(folder_ / "export");
    writeFile(folder_ / "export/liggghts_walls.stl", "mine");
    expectError(
        ErrorCode::cannotCreate, [&] { exportRun(request(ExportFormat::liggghts)); },
        "liggghts_walls.stl", "--overwrite");
    EXPECT_EQ(readFile(folder_ / "export/liggghts_walls.stl"), "mine");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "export/liggghts.in"));
    expectError(
        ErrorCode::usage, [] { std::ignore = exportFormat("ligghts"); }, "liggghts");
}

TEST_F(ExportRun, OfAnInputRefusesAFrameWithoutSpheres)
{
    ASSERT_TRUE(run_.frames.front().states.empty());
    expectError(
        ErrorCode::usage, [&] { exportRun(request(ExportFormat::mfix, "0")); }, "no sphere yet",
        "--frames");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "export/particle_input.dat"));
}

TEST_F(ExportRun, RefusesWhatIsNotThere)
{
    expectError(
        ErrorCode::usage, [&] { exportRun(request(ExportFormat::csv, "100000")); }, "100000");
    expectError(
        ErrorCode::usage, [&] { exportRun(request(ExportFormat::csv, "8..0")); }, "8..0");
    expectError(
        ErrorCode::usage, [] { std::ignore = exportFormat("vpt"); }, "vpt", "vtp");
    ExportRequest missing = request(ExportFormat::csv);
    missing.run = folder_ / "nothing";
    expectError(
        ErrorCode::inputMissing, [&] { exportRun(missing); }, "nothing");
    writeFile(folder_ / "text", "no run");
    missing.run = folder_ / "text";
    expectError(
        ErrorCode::badData, [&] { exportRun(missing); }, "text");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "export"));
}

TEST_F(ExportRun, OfATornRunWritesItsWholeFramesAndSaysSo)
{
    const std::string bytes = readFile(folder_ / "run.frost");
    writeFile(folder_ / "run.frost", bytes.substr(0, bytes.size() - 40));
    const ExportResult result = exportRun(request(ExportFormat::csv, "all"));
    EXPECT_TRUE(result.unfinished);
    EXPECT_GT(result.frames, 0U);
}

TEST_F(ExportRun, ThatIsStoppedLeavesNoPart)
{
    expectError(
        ErrorCode::stoppedEarly,
        [&]
        {
            exportRun(request(ExportFormat::lammpsDump),
                      [](std::size_t done, std::size_t) { return done < 3; });
        },
        "stopped");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "export"), {}), 0);
}

TEST_F(ExportRun, GivesTheSameBytesEachTime)
{
    for (const ExportFormatInfo& format : exportFormats())
    {
        ExportRequest once = request(format.format);
        ExportRequest twice = once;
        once.out = folder_ / "a";
        twice.out = folder_ / "b";
        const ExportResult a = exportRun(once);
        const ExportResult b = exportRun(twice);
        ASSERT_EQ(a.files.size(), b.files.size());
        for (std::size_t i = 0; i < a.files.size(); ++i)
        {
            EXPECT_EQ(readFile(a.files[i]), readFile(b.files[i])) << a.files[i];
        }
    }
}

} // namespace
} // namespace frostfill

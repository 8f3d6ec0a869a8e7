// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "unit/export/exported_run.hpp"

#include <frostfill/fill.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
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

TEST_F(ExportRun, RefusesAnOptionThatItsFormatDoesNotTakeBeforeItWrites)
{
    const std::vector<std::string> measured = {"vtp", "lammps-dump",   "xyz",
                                               "glb", "glb-instanced", "csv"};
    for (const ExportFormatInfo& format : exportFormats())
    {
        SCOPED_TRACE(format.name);
        ExportRequest asked = request(format.format, "last");
        asked.measured = {"sphere_contacts"};
        if (std::find(measured.begin(), measured.end(), format.name) != measured.end())
        {
            EXPECT_NO_THROW(exportRun(asked));
            asked.out = folder_ / "new";
            asked.measured = {"nothing"};
            expectError(
                ErrorCode::usage, [&] { exportRun(asked); }, "nothing");
        }
        else
        {
            asked.out = folder_ / "new";
            expectError(
                ErrorCode::usage, [&] { exportRun(asked); }, format.name, "--measure", "csv");
        }
        EXPECT_FALSE(std::filesystem::exists(folder_ / "new"));
    }
    requireOption(ExportFormat::vti, "voxels");
    requireOption(ExportFormat::glb, "no-shell");
    expectError(
        ErrorCode::usage, [] { requireOption(ExportFormat::csv, "voxels"); },
        "csv takes no --voxels, which is for vti, npy");
}

nlohmann::json jsonOfGlb(const std::filesystem::path& file)
{
    const std::string bytes = readFile(file);
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + 12, sizeof size);
    return nlohmann::json::parse(bytes.substr(20, size));
}

TEST_F(ExportRun, LeavesTheShellOutOfGltfIfAsked)
{
    for (const ExportFormat format : {ExportFormat::glb, ExportFormat::glbInstanced})
    {
        ExportRequest asked = request(format, "last");
        const auto with = jsonOfGlb(exportRun(asked).files[0]);
        asked.overwrite = true;
        asked.shell = false;
        const auto without = jsonOfGlb(exportRun(asked).files[0]);
        EXPECT_EQ(with["meshes"].size(), 4U);
        EXPECT_EQ(without["meshes"].size(), 3U);
        EXPECT_EQ(with["nodes"].size(), without["nodes"].size() + 1);
        EXPECT_NE(with.dump().find("shell"), std::string::npos);
        EXPECT_EQ(without.dump().find("shell"), std::string::npos);
    }
}

// A run of a mesh in millimetres.
TEST(ExportOfMillimetres, IsInMetresWhereTheProgramTakesNothingElse)
{
    const test::TemporaryFolder folder;
    Scene scene = test::fewSpheres();
    scene.object.unitsPerMetre = 1000;
    test::recordWithOracle(scene, folder.path());
    RunFileReader reader(folder / "run.frost");
    (void)reader.seek(reader.frames().size() - 1);
    const Eigen::AlignedBox3d box = boundingBox(reader.mesh());
    const auto write = [&](ExportFormat format)
    {
        return exportRun(
            {.run = folder.path(), .format = format, .frames = "last", .out = folder / "export"});
    };
    const ExportResult foam = write(ExportFormat::openFoam);
    EXPECT_EQ(foam.unitsPerMetre, 1);
    const TriangleMesh wall = readMesh(folder / "export/openfoam/constant/triSurface/wall.stl");
    EXPECT_NEAR(boundingBox(wall).sizes().x(), box.sizes().x() / 1000, 1e-9);
    const auto summary = nlohmann::json::parse(readFile(folder / "export/openfoam/bed.json"));
    EXPECT_NEAR(summary["mean_diameter"].get<double>(), 2 * reader.radii()[0] / 1000, 1e-12);
    EXPECT_EQ(summary["units_per_metre"], 1);
    const std::vector<double> corners =
        numbersBehind("vertices\n(\n    (", folder / "export/openfoam/system/blockMeshDict");
    EXPECT_LT(std::abs(corners.at(0)), box.sizes().maxCoeff() / 1000);

    EXPECT_EQ(write(ExportFormat::glb).unitsPerMetre, 1);
    const auto world = jsonOfGlb(folder / "export/run.glb")["nodes"].back();
    EXPECT_EQ(world["name"], "world");
    EXPECT_EQ(world["scale"], nlohmann::json({0.001, 0.001, 0.001}));

    EXPECT_EQ(write(ExportFormat::vti).unitsPerMetre, 1000);
    const auto volume = nlohmann::json::parse(readFile(folder / "export/bed.vti.json"));
    EXPECT_EQ(volume["units_per_metre"], 1000);
    EXPECT_NEAR(volume["mean_diameter"].get<double>(), 2 * reader.radii()[0], 1e-12);
}

} // namespace
} // namespace frostfill

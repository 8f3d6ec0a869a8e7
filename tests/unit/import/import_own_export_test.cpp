// SPDX-License-Identifier: MIT
// What we export and import again is the same run, and an export that was cut off anywhere is
// imported up to its last whole step.
#include "unit/export/exported_run.hpp"
#include "unit/import/imported_run.hpp"

#include <frostfill/error.hpp>
#include <frostfill/export.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using test::ReadFrame;
using test::writeFile;

class ImportOfOurOwnExport : public ::testing::Test
{
protected:
    void exportAs(ExportFormat format, const Scene& scene)
    {
        test::recordWithOracle(scene, folder_.path());
        original_ = test::framesOf(folder_.path());
        const ExportResult result = exportRun(
            {.run = folder_.path(), .format = format, .frames = "all", .out = folder_ / "export"});
        request_.file = result.files.front();
        request_.directory = folder_ / "again";
        request_.overwrite = true;
        savePly(RunFileReader(folder_ / "run.frost").mesh(), folder_ / "mesh.ply");
        request_.mesh = (folder_ / "mesh.ply").string();
    }
    test::TemporaryFolder folder_;
    std::vector<ReadFrame> original_;
    ImportRequest request_;
};

void expectTheSame(const std::vector<ReadFrame>& found, const std::vector<ReadFrame>& wanted)
{
    for (std::size_t k = 0; k < found.size(); ++k)
    {
        ASSERT_EQ(found[k].states, wanted[k].states) << "frame " << k;
        EXPECT_EQ(found[k].radii, wanted[k].radii) << "frame " << k;
        EXPECT_EQ(found[k].groups, wanted[k].groups) << "frame " << k;
        EXPECT_EQ(found[k].speeds, wanted[k].speeds) << "frame " << k;
        EXPECT_EQ(found[k].contacts, wanted[k].contacts) << "frame " << k;
        EXPECT_EQ(found[k].time, wanted[k].time);
        for (std::size_t i = 0; i < found[k].centres.size(); ++i)
        {
            // Text keeps every bit, and moving spheres are on the grid of the file already.
            EXPECT_EQ(found[k].centres[i], wanted[k].centres[i]) << "frame " << k << ", " << i;
        }
    }
}

TEST_F(ImportOfOurOwnExport, OfADumpGivesTheSameSpheres)
{
    exportAs(ExportFormat::lammpsDump, test::fewSpheres());
    const ImportResult result = importRun(request_);
    EXPECT_TRUE(result.statesGiven);
    EXPECT_EQ(result.vanished, 0U);
    const auto frames = test::framesOf(folder_ / "again");
    ASSERT_EQ(frames.size(), original_.size());
    ASSERT_GT(frames.size(), 20U);
    expectTheSame(frames, original_);
}

TEST_F(ImportOfOurOwnExport, OfExtendedXyzGivesTheSameSpheres)
{
    exportAs(ExportFormat::xyz, test::fewSpheres());
    EXPECT_TRUE(importRun(request_).statesGiven);
    const auto frames = test::framesOf(folder_ / "again");
    ASSERT_EQ(frames.size(), original_.size());
    expectTheSame(frames, original_);
}

TEST_F(ImportOfOurOwnExport, CutAtTwoHundredLengthsGivesItsWholeSteps)
{
    for (const ExportFormat format : {ExportFormat::lammpsDump, ExportFormat::xyz})
    {
        Scene scene = test::fewSpheres();
        scene.spheres.count = 6;
        exportAs(format, scene);
        importRun(request_);
        const auto whole = test::framesOf(folder_ / "again");
        const std::string text = test::readFile(request_.file);
        request_.file = folder_ / "cut";
        std::size_t longest = 0;
        std::size_t torn = 0;
        for (std::size_t k = 0; k < 200; ++k)
        {
            // Lengths of all remainders: the cuts fall into headings, numbers and ends of lines.
            writeFile(request_.file, text.substr(0, text.size() * k / 200 + k % 7));
            try
            {
                const ImportResult result = importRun(request_);
                const auto frames = test::framesOf(folder_ / "again");
                ASSERT_EQ(frames.size(), result.steps);
                ASSERT_LE(frames.size(), whole.size());
                ASSERT_GE(frames.size(), longest);
                longest = frames.size();
                torn += result.torn.empty() ? 0 : 1;
                expectTheSame(frames, whole);
            }
            catch (const Error& error)
            {
                EXPECT_EQ(error.code(), ErrorCode::badData) << error.what();
                EXPECT_EQ(longest, 0U) << error.what();
            }
        }
        EXPECT_GT(longest, whole.size() / 2);
        EXPECT_GT(torn, 100U);
    }
}

} // namespace
} // namespace frostfill

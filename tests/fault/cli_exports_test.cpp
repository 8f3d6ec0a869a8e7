// SPDX-License-Identifier: MIT
// The commands import and fill --export, as their user meets them.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;

class Exports : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    [[nodiscard]] bool isThere(const std::string& file) const
    {
        return std::filesystem::exists(folder_ / file);
    }
    /// The lines of the only file in a folder, without set and speed: groups become sets.
    [[nodiscard]] std::vector<std::string> rowsOf(const std::string& folder) const
    {
        std::ifstream file(std::filesystem::directory_iterator(folder_ / folder)->path());
        std::vector<std::string> rows;
        for (std::string row; std::getline(file, row);)
        {
            const std::string contacts = row.substr(row.rfind(','));
            for (int column = 0; column < 3; ++column)
            {
                row.resize(row.rfind(','));
            }
            rows.push_back(row + contacts);
        }
        return rows;
    }
    test::TemporaryFolder folder_;
};

const std::string kTwoPictures = "fill cube --count 6 --size 64x48 --max-frames 2 --duration 0.3 ";

TEST_F(Exports, OfAFillAreWhatTheCommandExportWrites)
{
    const Answer filled = run(kTwoPictures + "--export csv,xyz --out run");
    EXPECT_EQ(filled.code, 0) << filled.errors;
    EXPECT_NE(filled.output.find("spheres.xyz"), std::string::npos) << filled.output;
    ASSERT_EQ(run("export run --to csv,xyz --out again --quiet").code, 0);
    for (const auto& file : std::filesystem::directory_iterator(folder_ / "again"))
    {
        const std::string name = file.path().filename().string();
        EXPECT_EQ(test::readFile(file.path()), test::readFile(folder_ / "run/export" / name));
    }
    const Answer one = run("export run --to xyz --frames 1 --out one");
    EXPECT_NE(one.output.find(": 1 frame,"), std::string::npos) << one.output;
    // JSON has standard output for itself, and the run before is replaced with its exports.
    const Answer json = run(kTwoPictures + "--export csv,xyz --out run --overwrite --json");
    EXPECT_EQ(json.code, 0) << json.errors;
    EXPECT_EQ(json.output, test::readFile(folder_ / "run/summary.json"));
    // A run that has ended is exported without being run again.
    ASSERT_EQ(run("fill --resume run --export npz").code, 0);
    EXPECT_TRUE(isThere("run/export/run.npz"));
}

TEST_F(Exports, AreRefusedBeforeTheRunThatCouldNotBeExported)
{
    const Answer unkept = run(kTwoPictures + "--export csv --keep-run off --out run");
    EXPECT_EQ(unkept.code, 64);
    EXPECT_NE(unkept.errors.find("--keep-run"), std::string::npos) << unkept.errors;
    EXPECT_EQ(run("fill cube --count 6 --frames none --export csv --out run").code, 64);
    const Answer unknown = run(kTwoPictures + "--export csw --out run");
    EXPECT_EQ(unknown.code, 64);
    EXPECT_NE(unknown.errors.find("did you mean csv"), std::string::npos) << unknown.errors;
    EXPECT_FALSE(isThere("run"));
}

TEST_F(Exports, AreImportedRenderedAndExportedAgain)
{
    ASSERT_EQ(run(kTwoPictures + "--export lammps-dump --out run --quiet").code, 0);
    const Answer imported = run("import run/export/spheres.dump --mesh run/mesh.ply --out again");
    EXPECT_EQ(imported.code, 0) << imported.errors;
    EXPECT_NE(imported.output.find("6 spheres at the end"), std::string::npos) << imported.output;
    EXPECT_NE(imported.output.find("6 at rest, as the file says"), std::string::npos);
    EXPECT_EQ(run("import run/export/spheres.dump --out again").code, 73);
    EXPECT_EQ(run("render again --size 64x48 --frames last --quiet").code, 0);
    ASSERT_EQ(run("export run --to csv --out a --quiet").code, 0);
    ASSERT_EQ(run("export again --to csv --out b --quiet").code, 0);
    EXPECT_EQ(rowsOf("a").size(), 7U);
    EXPECT_EQ(rowsOf("a"), rowsOf("b"));
    const Answer resumed = run("fill --resume again");
    EXPECT_EQ(resumed.code, 64);
    EXPECT_NE(resumed.errors.find("imported"), std::string::npos) << resumed.errors;
    ASSERT_EQ(run("import run/export/spheres.dump --up z --out tall --quiet").code, 0);
    ASSERT_EQ(run("view tall --quiet").code, 0);
    EXPECT_NE(test::readFile(folder_ / "tall/view.html").find(R"("up":[0.0,0.0,1.0])"),
              std::string::npos);
    EXPECT_EQ(run("import missing.dump").code, 66);
    EXPECT_EQ(run("import run/export/spheres.dump --timestep 0").code, 64);
}

} // namespace
} // namespace frostfill

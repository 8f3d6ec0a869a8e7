// SPDX-License-Identifier: MIT
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;
using test::writeFile;

const std::string kFps = "fps cube --count 42 --repeats 2 --no-render --quiet ";

class MeasureCommands : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    test::TemporaryFolder folder_;
};

std::ptrdiff_t lines(const std::string& text)
{
    return std::count(text.begin(), text.end(), '\n');
}

TEST_F(MeasureCommands, FpsPrintsThePaperBesideOurs)
{
    const Answer answer = run(kFps);
    ASSERT_EQ(answer.code, 0) << answer.errors;
    for (const char* word : {"paper", "loop", "list", "tree", "grid", "fast", "17", "35", "0.8",
                             "nothing drawn", "2 runs each"})
    {
        EXPECT_NE(answer.output.find(word), std::string::npos) << word << "\n" << answer.output;
    }
    EXPECT_EQ(answer.errors, "");
}

TEST_F(MeasureCommands, FpsPrintsMarkdownCsvAndJson)
{
    EXPECT_NE(run(kFps + "--markdown").output.find("|---|"), std::string::npos);

    // A row a set: two of them, for the paper's four searches and at least one for ours.
    const Answer csv = run(kFps + "--csv");
    EXPECT_EQ(csv.output.rfind("object,search,set,", 0), 0u) << csv.output;
    EXPECT_GE(lines(csv.output), 1 + 4 * 2 + 1);

    const Answer json = run(kFps + "--json --searches tree,grid");
    const auto document = nlohmann::json::parse(json.output, nullptr, false);
    ASSERT_TRUE(document.is_object()) << json.output;
    const auto& cube = document["objects"][0];
    EXPECT_EQ(cube["triangles"], 768);
    EXPECT_EQ(cube["spheres"], 42);
    EXPECT_EQ(cube["searches"].size(), 2u);
    EXPECT_GE(cube["searches"][0]["sets"].size(), 2u);
    EXPECT_EQ(document["machine"]["renderer"], "");

    EXPECT_EQ(run(kFps + "--json --csv").code, 64);
    EXPECT_EQ(run(kFps + "--searches octree").code, 64);
}

TEST_F(MeasureCommands, FpsMeasuresPicturesToo)
{
    const Answer answer = run("fps cube --count 21 --repeats 1 --quiet --searches grid --json");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    const auto document = nlohmann::json::parse(answer.output, nullptr, false);
    const auto& fps = document["objects"][0]["searches"][0]["frames_per_second"];
    EXPECT_GT(fps["simulation"], fps["drawing"]);
    EXPECT_GT(fps["drawing"], fps["readback"]);
    EXPECT_GT(fps["readback"], fps["png"]);
    EXPECT_GT(fps["png"], 0);
    EXPECT_NE(document["machine"]["renderer"], "");
}

TEST_F(MeasureCommands, FpsComparesAndEndsWithTwoForARegression)
{
    ASSERT_EQ(run(kFps + "--searches loop --json >before.json").code, 0);
    const Answer same = run(kFps + "--searches loop --compare before.json --threshold 100000");
    EXPECT_EQ(same.code, 0) << same.output << same.errors;

    auto older = nlohmann::json::parse(readFile(folder_ / "before.json"));
    auto& searches = older["objects"][0]["searches"];
    searches[0]["step_ms_of_runs"]["fastest_run"] = 1e-9;
    writeFile(folder_ / "faster.json", older.dump());
    const Answer slower = run(kFps + "--searches loop --compare faster.json");
    EXPECT_EQ(slower.code, 2);
    EXPECT_NE(slower.output.find("regressed"), std::string::npos) << slower.output;

    EXPECT_EQ(run(kFps + "--compare missing.json").code, 66);
    writeFile(folder_ / "broken.json", "{");
    EXPECT_EQ(run(kFps + "--searches loop --compare broken.json").code, 65);
}

TEST_F(MeasureCommands, FpsReadsScenesAndMeshFiles)
{
    writeFile(folder_ / "small.toml", "preset = \"paper\"\n[object]\nmesh = \"torus\"\n"
                                      "[spheres]\ncount = 20\ngroup_size = 5\n");
    const Answer answer =
        run("fps small.toml --repeats 1 --no-render --quiet --searches grid --json");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    const auto document = nlohmann::json::parse(answer.output, nullptr, false);
    EXPECT_EQ(document["objects"][0]["group_size"], 5);
    EXPECT_EQ(run("fps missing.stl --no-render --quiet").code, 66);
}

TEST_F(MeasureCommands, BenchOperationsAgreesWithTheLemmas)
{
    const Answer answer = run("bench operations --quick --out here");
    ASSERT_EQ(answer.code, 0) << answer.output << answer.errors;
    EXPECT_NE(answer.output.find("verdict: tests equal"), std::string::npos) << answer.output;
    // 20 groups one by one and in fours, with and without discards.
    EXPECT_EQ(lines(readFile(folder_ / "here/operations.csv")), 1 + 2 * (20 + 5));
    EXPECT_EQ(run("bench").code, 64);
}

TEST_F(MeasureCommands, BenchGrowthTellsHowEachCostGrows)
{
    const Answer answer = run("bench growth --quick --out here");
    EXPECT_TRUE(answer.code == 0 || answer.code == 2) << answer.errors; // as the clock says
    for (const char* cost : {"loading grows as triangles^", "a sphere grows as triangles^",
                             "a picture grows as triangles^", "verdict: "})
    {
        EXPECT_NE(answer.output.find(cost), std::string::npos) << answer.output;
    }
    EXPECT_EQ(lines(readFile(folder_ / "here/triangles.csv")), 1 + 3);
}

TEST_F(MeasureCommands, FiguresListsThemAndRefusesOthers)
{
    const Answer answer = run("figures --list");
    EXPECT_EQ(answer.code, 0);
    for (const char* name : {"volume", "interaction", "times", "claim", "operations", "filling",
                             "cutaways", "discarded", "density"})
    {
        EXPECT_NE(answer.output.find(name), std::string::npos) << name;
    }
    EXPECT_EQ(run("figures --only nothing").code, 64);
}

TEST_F(MeasureCommands, FiguresAreTheSameByteForByte)
{
    const std::string which = "figures --quick --quiet --only operations,interaction,volume ";
    ASSERT_EQ(run(which + "--out a").code, 0);
    ASSERT_EQ(run(which + "--out b").code, 0);
    std::size_t files = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder_ / "a"))
    {
        const std::string name = file.path().filename().string();
        EXPECT_EQ(readFile(file.path()), readFile(folder_ / ("b/" + name))) << name;
        EXPECT_GT(std::filesystem::file_size(file.path()), 0u) << name;
        ++files;
    }
    // Three scripts and their style, SVG and PNG of each, and the data.
    EXPECT_GE(files, 4u + 6 + 3);
}

TEST_F(MeasureCommands, FiguresOfAnObjectOfOnesOwnComeWithPdfAndAreTheSameByteForByte)
{
    const std::string which = "figures --object sphere --quick --quiet ";
    ASSERT_EQ(run(which + "--out a").code, 0);
    ASSERT_EQ(run(which + "--only stages,volume --out b").code, 0);
    for (const char* name : {"stages", "cutaways", "discards", "volume"})
    {
        for (const char* ending : {".svg", ".png", ".pdf"})
        {
            EXPECT_TRUE(std::filesystem::exists(folder_ / fmt::format("a/{}{}", name, ending)))
                << name << ending;
        }
    }
    for (const std::string name : {"stages.pdf", "volume.pdf", "volume.svg", "stages.png"})
    {
        EXPECT_EQ(readFile(folder_ / ("a/" + name)), readFile(folder_ / ("b/" + name))) << name;
    }
    EXPECT_EQ(run(which + "--only operations --out c").code, 64);
    EXPECT_EQ(run("figures --object nothing.obj --quiet --out d").code, 66);
}

TEST_F(MeasureCommands, FiguresDrawRecordedTimesAgain)
{
    std::filesystem::create_directory(folder_ / "recorded");
    writeFile(folder_ / "recorded/times.csv", "number,object,series,ms,low,high\n"
                                              "0,torus,loop,0.1,0.05,0.2\n");
    writeFile(folder_ / "recorded/fps.csv", "object\n");
    writeFile(folder_ / "recorded/fps.md", "table\n");
    const Answer answer = run("figures --only times --recorded recorded --out new");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.errors.find("--measure"), std::string::npos) << answer.errors;
    EXPECT_EQ(readFile(folder_ / "new/times.csv"), readFile(folder_ / "recorded/times.csv"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "new/times.svg"));
}

TEST_F(MeasureCommands, FiguresSayWhatTheyMeasureWhereNoTimesAreRecorded)
{
    const Answer answer =
        test::runProgram("figures --only times,volume --out new", folder_.path(), "timeout 5");
    EXPECT_NE(answer.errors.find("docs/figures has no recorded times: these are measured, which "
                                 "takes 2 minutes or more: times\n"),
              std::string::npos)
        << answer.errors;
}

TEST_F(MeasureCommands, FiguresSayHowToGetGnuplot)
{
    const Answer missing = test::runProgram("figures --quick --only operations --out b",
                                            folder_.path(), "PATH=/nowhere");
    EXPECT_EQ(missing.code, 69);
    EXPECT_NE(missing.errors.find("apt-get install gnuplot-nox"), std::string::npos)
        << missing.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b"));
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>
#include <vector>

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

TEST_F(MeasureCommands, AnalyseDrawsItsTablesAndSaysHowToGetMatplotlib)
{
    ASSERT_EQ(
        run("fill cube --count 200 --frames none --set frames.keep_run=true --quiet --out run")
            .code,
        0);
    const std::string analyse = "analyse run --only porosity,contacts,pairs --figures --quiet ";
    writeFile(folder_ / "matplotlib.py", "raise ImportError");
    const Answer missing =
        test::runProgram(analyse + "--out new", folder_.path(), "PYTHONPATH=$PWD");
    std::filesystem::remove(folder_ / "matplotlib.py");
    EXPECT_EQ(missing.code, 69);
    EXPECT_NE(missing.errors.find("apt-get install python3-matplotlib"), std::string::npos)
        << missing.errors;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "new"));
    const Answer drawn = run(analyse + "--out found");
    ASSERT_EQ(drawn.code, 0) << drawn.errors;
    for (const std::string name : {"porosity", "contacts", "pairs"})
    {
        for (const char* ending : {".png", ".svg"})
        {
            EXPECT_GT(readFile(folder_ / ("found/" + name + ending)).size(), 300u)
                << name << ending;
        }
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "found/order.png"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "found/figures.py"));
}

/// frostfill-lab, which users do not have.
class Laboratory : public MeasureCommands
{
protected:
    [[nodiscard]] Answer lab(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path(), "", FROSTFILL_LAB_PROGRAM);
    }
};

TEST_F(Laboratory, AgreesWithTheLemmas)
{
    const Answer answer = lab("operations --quick --out here");
    ASSERT_EQ(answer.code, 0) << answer.output << answer.errors;
    EXPECT_NE(answer.output.find("verdict: tests equal"), std::string::npos) << answer.output;
    // 20 groups one by one and in fours, with and without discards.
    EXPECT_EQ(lines(readFile(folder_ / "here/operations.csv")), 1 + 2 * (20 + 5));
    EXPECT_EQ(lab("").code, 64);
    EXPECT_EQ(lab("nothing").code, 64);
    EXPECT_EQ(run("bench operations").code, 64) << "it is no command of the program";
}

TEST_F(Laboratory, TellsHowEachCostGrowsWithTriangles)
{
    const Answer answer = lab("triangles --quick --out here");
    EXPECT_TRUE(answer.code == 0 || answer.code == 2) << answer.errors; // as the clock says
    for (const char* cost : {"loading grows as triangles^", "a sphere grows as triangles^",
                             "a picture grows as triangles^", "verdict: "})
    {
        EXPECT_NE(answer.output.find(cost), std::string::npos) << answer.output;
    }
    EXPECT_EQ(lines(readFile(folder_ / "here/triangles.csv")), 1 + 3);
    EXPECT_NE(answer.output.find("here/triangles.csv\ntriangles"), std::string::npos)
        << "the table that it writes is shown";
}

TEST_F(Laboratory, WritesTheTablesOfItsFigures)
{
    for (const auto& [command, tables] :
         {std::pair("closed-forms", std::vector<const char*>{"closed-forms.csv"}),
          std::pair("claim", std::vector<const char*>{"claim.csv"}),
          std::pair("times", std::vector<const char*>{"times.csv", "fps.csv", "fps.md"})})
    {
        const Answer answer = lab(std::string(command) + " --quick --out here");
        EXPECT_EQ(answer.code, 0) << command << answer.errors;
        for (const char* table : tables)
        {
            EXPECT_GT(lines(readFile(folder_ / (std::string("here/") + table))), 5) << table;
        }
    }
}

TEST_F(Laboratory, RefusesEnginesThatCannotBeCompared)
{
    writeFile(folder_ / "text", "no program\n");
    for (const auto& [arguments, code, words] :
         {std::tuple("peers", 64, "name an engine by --peer"),
          std::tuple("peers --peer Jolt", 64, "'Jolt' must be NAME=PROGRAM"),
          std::tuple("peers --peer a,b=text", 64, "cannot name an engine"),
          std::tuple("peers --peer A=text --peer A=b", 64, "two engines have the name A"),
          std::tuple("peers --peer Frostfill=text", 64, "two engines have the name Frostfill"),
          std::tuple("rest --peer Jolt=missing", 69,
                     "the engine Jolt cannot be started: 'missing': No such file"),
          std::tuple("peers --peer Jolt=./text", 69, "'./text': Permission denied"),
          std::tuple("peers --peer Jolt=/bin/false", 69,
                     "the engine Jolt was to answer 'ready', but ended with code 1"),
          std::tuple("peers --peer Jolt=cat", 69, "but said 'frostfill-peer 1'")})
    {
        const Answer answer = lab(arguments);
        EXPECT_EQ(answer.code, code) << arguments;
        EXPECT_NE(answer.errors.find(words), std::string::npos) << answer.errors;
    }
}

} // namespace
} // namespace frostfill

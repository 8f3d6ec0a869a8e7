// SPDX-License-Identifier: MIT
// The command check, as its user meets it.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <utility>

namespace frostfill
{
namespace
{

using test::Answer;
using test::writeFile;

class CheckCommand : public ::testing::Test
{
protected:
    CheckCommand()
    {
        writeFile(folder_ / "two.csv", "x,y,z,radius\n0,-0.75,0,0.25\n0,-0.275,0,0.25\n");
    }
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    test::TemporaryFolder folder_;
};

TEST_F(CheckCommand, MeasuresThePackingOfAnybody)
{
    const Answer table = run("check two.csv --mesh cube");
    EXPECT_EQ(table.code, 0) << table.errors;
    EXPECT_NE(table.output.find("0.1 of the smaller radius"), std::string::npos) << table.output;
    const Answer answer = run("check two.csv --mesh cube --json");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    const auto json = nlohmann::json::parse(answer.output);
    EXPECT_NEAR(json["max_overlap_over_radius"].get<double>(), 0.1, 1e-9);
    EXPECT_EQ(json["centres_outside"], 0);
    EXPECT_EQ(json["spheres"], 2);
}

TEST_F(CheckCommand, MeasuresARunAsItsSummarySays)
{
    ASSERT_EQ(run("fill cube --radius 0.2 --count 40 --frames none --quiet --out run").code, 0);
    const auto summary =
        nlohmann::json::parse(test::readFile(folder_ / "run/summary.json"))["error"];
    const Answer answer = run("check run --json");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    const auto json = nlohmann::json::parse(answer.output);
    for (const char* key : {"max_overlap_over_radius", "max_wall_overlap_over_radius",
                            "centres_outside", "unsupported_frozen", "volume_mesh"})
    {
        EXPECT_EQ(json[key], summary[key]) << key;
    }
    EXPECT_EQ(run("check run --mesh sphere --max-outside 0").code, 2);
}

TEST_F(CheckCommand, EndsWithTwoWhereMoreIsFoundThanMayBe)
{
    EXPECT_EQ(run("check two.csv --mesh cube --max-overlap 0.2 --max-unsupported 2").code, 0);
    const Answer answer = run("check two.csv --mesh cube --max-overlap 0.01 --max-outside 0");
    EXPECT_EQ(answer.code, 2);
    EXPECT_NE(answer.errors.find("largest overlap 0.1, more than 0.01"), std::string::npos)
        << answer.errors;
    EXPECT_EQ(answer.errors.find("outside"), std::string::npos) << answer.errors;
    // A place that is no number is nowhere inside.
    writeFile(folder_ / "lost.csv", "x,y,z,radius\n0,-0.75,0,0.25\nnan,0,0,0.25\n");
    EXPECT_EQ(run("check lost.csv --mesh cube --max-outside 1").code, 0);
    const Answer lost = run("check lost.csv --mesh cube --max-outside 0");
    EXPECT_EQ(lost.code, 2);
    EXPECT_NE(lost.errors.find("centres outside 1, more than 0"), std::string::npos) << lost.errors;
}

// Two on the floor and one between them: 30 degrees.
TEST_F(CheckCommand, SaysFromWhichFrictionAPileStands)
{
    writeFile(folder_ / "pile.csv",
              fmt::format("x,y,z,radius\n-0.2,-0.8,0,0.2\n0.2,-0.8,0,0.2\n0,{},0,0.2\n",
                          -0.8 + 0.2 * std::sqrt(3.0)));
    const std::string command = "check pile.csv --mesh cube --set judge.unbalance=0.001";
    const auto judge = [&](const std::string& friction)
    {
        const Answer answer = run(command + " --json --set judge.friction=" + friction);
        EXPECT_EQ(answer.code, 0) << answer.errors;
        return nlohmann::json::parse(answer.output)["equilibrium"];
    };
    const double least = 2 - std::sqrt(3.0); // tan 15 degrees
    const auto falls = judge("0.25");
    EXPECT_EQ(falls["friction"], 0.25);
    EXPECT_EQ(falls["at_rest"], 3);
    EXPECT_GT(falls["unbalanced"], 0);
    EXPECT_TRUE(falls["settled"]);
    EXPECT_NEAR(falls["least_friction"].get<double>(), least, 0.01 * least);
    EXPECT_EQ(judge("0.28")["unbalanced"], 0);
    EXPECT_FALSE(nlohmann::json::parse(run("check pile.csv --mesh cube --json").output)
                     .contains("equilibrium"));
    const Answer table = run(command + " --set judge.friction=0.25");
    EXPECT_NE(table.output.find("unbalanced, friction 0.25"), std::string::npos) << table.output;
    EXPECT_NE(table.output.find("stands from a friction of    0.2"), std::string::npos)
        << table.output;
    EXPECT_EQ(run(command + " --set judge.friction=0.28 --max-unbalanced 0").code, 0);
    const Answer more = run(command + " --set judge.friction=0.25 --max-unbalanced 0");
    EXPECT_EQ(more.code, 2);
    EXPECT_NE(more.errors.find("unbalanced spheres"), std::string::npos) << more.errors;
    writeFile(folder_ / "air.csv", "x,y,z,radius\n0,0,0,0.2\n");
    const Answer air = run("check air.csv --mesh cube --set judge.friction=1");
    EXPECT_NE(air.output.find("none up to 8"), std::string::npos) << air.output;
}

TEST_F(CheckCommand, JudgesARunUnderTheFrictionWithWhichItHasSettled)
{
    ASSERT_EQ(run("fill cube --count 60 --radius 0.2 --motion skip --rest joint --friction 0.5 "
                  "--frames none --out settled")
                  .code,
              0);
    const auto error =
        nlohmann::json::parse(test::readFile(folder_ / "settled/summary.json"))["error"];
    EXPECT_EQ(error["settling"]["rounds"], 1);
    EXPECT_EQ(error["settling"]["settled"], true);
    EXPECT_LT(error["settling"]["largest_unbalance"], 0.1);
    const Answer answer = run("check settled --json --set judge.friction=0.5 --max-unbalanced 0");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    const auto again = nlohmann::json::parse(run("check settled --json").output);
    EXPECT_EQ(again["unsupported_frozen"], 0);
    EXPECT_EQ(error["unsupported_frozen"], 0);
    for (const auto& [wrong, says] :
         {std::pair("--friction 0.3", "(--rest) joint"),
          {"--set rest.wall_friction=0.1", "(--rest) joint"},
          {"--rest joint --friction -1", "--friction is '-1'"},
          {"--rest together", "--rest is 'together'"},
          {"--rest joint --set move.tilt=20", "omit move.tilt"},
          {"--rest joint --preset paper", "use the preset fast"},
          {"--rest joint --set rest.rolling_friction=much", "rest.rolling_friction is 'much'"}})
    {
        const Answer refused = run(std::string("fill cube --count 5 --out no ") + wrong);
        EXPECT_EQ(refused.code, 64) << wrong;
        EXPECT_NE(refused.errors.find(says), std::string::npos) << refused.errors;
    }
}

TEST_F(CheckCommand, TakesTheColumnsOfATableByName)
{
    writeFile(folder_ / "beads.csv", "size,a,b,c\n0.5,0,-0.75,0\n0.5,0,-0.275,0\n");
    const Answer answer =
        run("check beads.csv --mesh cube --columns x=a,y=b,z=c,diameter=size --json");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    const auto json = nlohmann::json::parse(answer.output);
    EXPECT_NEAR(json["max_overlap_over_radius"].get<double>(), 0.1, 1e-9);
    EXPECT_EQ(json["largest_radius"], 0.25);
    ASSERT_EQ(run("analyse beads.csv --mesh cube --columns x=2,y=3,z=4,diameter=1 --only contacts "
                  "--out found --quiet")
                  .code,
              0);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "found/contacts.csv"));
}

// In millimetres: no length of the tables lies between 0 and 1, as porosities do.
TEST_F(CheckCommand, AnalyseDrawsPorosityOfLargeLengths)
{
    writeFile(folder_ / "box.off",
              "OFF\n8 6 0\n0 0 0\n400 0 0\n400 0 400\n0 0 400\n0 400 0\n400 400 0\n"
              "400 400 400\n0 400 400\n4 0 1 2 3\n4 0 4 5 1\n4 1 5 6 2\n"
              "4 2 6 7 3\n4 3 7 4 0\n4 4 7 6 5\n");
    writeFile(folder_ / "beads.csv", "x,y,z,radius\n100,50,100,50\n250,50,250,50\n");
    const Answer answer =
        run("analyse beads.csv --mesh box.off --only porosity --figures --out found --quiet");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_GT(test::readFile(folder_ / "found/porosity.svg").size(), 10000U);
}

TEST_F(CheckCommand, APackingNeedsNoMeshForWhatNeedsNoWalls)
{
    writeFile(folder_ / "pair.csv", "x,y,z,radius\n0,0,0,0.5\n0.9,0,0,0.5\n");
    const Answer plain = run("check pair.csv");
    EXPECT_EQ(plain.code, 0) << plain.errors;
    EXPECT_NE(plain.errors.find("no mesh is given, and no --box"), std::string::npos);
    EXPECT_NE(plain.output.find("largest overlap              0.2 of"), std::string::npos);
    EXPECT_EQ(plain.output.find("carries"), std::string::npos) << plain.output;
    EXPECT_EQ(run("check pair.csv --max-overlap 0.3").code, 0);
    EXPECT_EQ(run("check pair.csv --box 1.5,2,2 --periodic --max-overlap 0.3").code, 2);
    EXPECT_NE(
        run("check pair.csv --box -1,-1,-1,2,1,1").output.find("volume of the mesh           12"),
        std::string::npos);
    ASSERT_EQ(run("analyse pair.csv --out found").code, 0);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "found/network.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "found/porosity_wall.csv"));
    EXPECT_NE(run("analyse pair.csv --box 1.5,2,2 --periodic --out found --overwrite")
                  .output.find("% of the box"),
              std::string::npos);
    for (const char* wrong : {"--max-outside 0", "--set judge.friction=1", "--box 1,2",
                              "--box 1,2,0", "--periodic", "--box 1,1,1 --mesh cube"})
    {
        EXPECT_EQ(run(std::string("check pair.csv ") + wrong).code, 64) << wrong;
    }
}

// In a cube that is half full, both say what they mean by the bulk.
TEST_F(CheckCommand, AnalyseFindsTheBulkOfWhichFillTells)
{
    const Answer filled =
        run("fill cube --radius 0.1 --count 550 --motion granular --rest joint "
            "--friction 0.3 --fraction 0.62 --frames none --set frames.keep_run=true --out run");
    ASSERT_EQ(filled.code, 0) << filled.errors;
    const char* words = "bulk: 4 r from the walls and from the surface";
    EXPECT_NE(filled.output.find(words), std::string::npos) << filled.output;
    const auto settling =
        nlohmann::json::parse(test::readFile(folder_ / "run/summary.json"))["error"]["settling"];
    EXPECT_EQ(settling["bulk_is"].get<std::string>().rfind(words, 0), 0U);
    const Answer table = run("analyse run --only porosity --out table");
    EXPECT_NE(table.output.find(words), std::string::npos) << table.output;
    const Answer answer = run("analyse run --only porosity --out found --json");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    const auto porosity = nlohmann::json::parse(answer.output)["porosity"];
    EXPECT_NEAR(1 - porosity["bulk"].get<double>(), settling["bulk_fraction"].get<double>(), 0.006);
    EXPECT_LT(porosity["sampled"], 0.5);
    // All that the cube encloses.
    const Answer whole = run("analyse run --only porosity --out whole --json --below 2");
    EXPECT_GT(nlohmann::json::parse(whole.output)["porosity"]["sampled"], 0.6);
    EXPECT_EQ(run("analyse run --below -1 --out new").code, 64);
}

} // namespace
} // namespace frostfill

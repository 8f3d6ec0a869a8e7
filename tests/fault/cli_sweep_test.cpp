// SPDX-License-Identifier: MIT
// The command sweep, dry runs and progress for programs, as their user meets them.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using nlohmann::json;
using test::Answer;
using test::readFile;
using test::writeFile;

class SweepCommand : public ::testing::Test
{
protected:
    SweepCommand()
    {
        writeFile(folder_ / "sweep.toml", "[scene]\nframes.which = \"none\"\n[sweep]\n"
                                          "object.mesh = [\"cube\", \"torus\"]\n"
                                          "spheres.radius = [0.25, 0.3]\nseed = [1, 2]\n");
    }
    [[nodiscard]] Answer run(const std::string& arguments,
                             const std::string& environment = "") const
    {
        return test::runProgram(arguments, folder_.path(), environment);
    }
    [[nodiscard]] bool isThere(const char* name) const
    {
        return std::filesystem::exists(folder_ / name);
    }
    test::TemporaryFolder folder_;
};

TEST_F(SweepCommand, DoesAllRunsThenNoneAndGathersATable)
{
    const Answer first = run("sweep sweep.toml");
    EXPECT_EQ(first.code, 0) << first.errors;
    EXPECT_NE(first.output.find("8/8 mesh=torus,radius=0.3,seed=2: done"), std::string::npos)
        << first.output;
    EXPECT_EQ(first.errors, ""); // progress is for terminals
    EXPECT_TRUE(isThere("output/sweep/table.csv"));
    const Answer again = run("sweep sweep.toml");
    EXPECT_EQ(again.code, 0);
    EXPECT_NE(again.output.find("8/8 mesh=torus,radius=0.3,seed=2: was done already"),
              std::string::npos)
        << again.output;
}

TEST_F(SweepCommand, RefusesToGatherWhatIsNotCompleteAndNamesIt)
{
    EXPECT_EQ(run("sweep sweep.toml --out out --shard 1/2").code, 0);
    EXPECT_FALSE(isThere("out/table.csv"));
    const Answer early = run("sweep sweep.toml --out out --gather");
    EXPECT_EQ(early.code, 65);
    EXPECT_NE(early.errors.find("mesh=cube,radius=0.25,seed=2: missing"), std::string::npos)
        << early.errors;
    EXPECT_NE(early.errors.find("4 done, 4 missing"), std::string::npos) << early.errors;
    EXPECT_FALSE(isThere("out/table.csv"));
    EXPECT_EQ(run("sweep sweep.toml --out out --gather --allow-incomplete").code, 75);
    EXPECT_NE(readFile(folder_ / "out/table.csv").find("missing"), std::string::npos);
    const Answer slurm = run("sweep sweep.toml --out out --shard slurm",
                             "SLURM_ARRAY_TASK_ID=5 SLURM_ARRAY_TASK_MIN=4 SLURM_ARRAY_TASK_MAX=5 "
                             "SLURM_ARRAY_TASK_STEP=1 SLURM_ARRAY_TASK_COUNT=2");
    EXPECT_EQ(slurm.code, 0) << slurm.errors;
    EXPECT_EQ(run("sweep sweep.toml --out out --gather").code, 0);
    EXPECT_EQ(json::parse(readFile(folder_ / "out/table.json")).size(), 8U);
}

TEST_F(SweepCommand, TellsByItsExitCodeThatARunHasFailed)
{
    writeFile(folder_ / "bad.toml", "[scene]\nframes.which = \"none\"\n[sweep]\n"
                                    "object.mesh = [\"nowhere.stl\", \"cube\"]\n"
                                    "spheres.radius = [0.4]\n");
    const Answer answer = run("sweep bad.toml");
    EXPECT_EQ(answer.code, 2);
    EXPECT_NE(answer.output.find("failed with 66: "), std::string::npos) << answer.output;
    EXPECT_NE(answer.output.find("1 done, 1 failed"), std::string::npos) << answer.output;
    EXPECT_NE(readFile(folder_ / "output/bad/table.csv").find("failed,66"), std::string::npos);
    EXPECT_EQ(run("sweep bad.toml --gather").code, 65);
    EXPECT_EQ(run("sweep bad.toml --gather --allow-incomplete").code, 2);
}

TEST_F(SweepCommand, SaysWhatIsWrongBeforeAnythingIsWritten)
{
    for (const auto& [arguments, code] :
         std::vector<std::pair<std::string, int>>{{"sweep nowhere.toml", 66},
                                                  {"sweep sweep.toml --shard 9/8", 64},
                                                  {"sweep sweep.toml --shard slurm", 64},
                                                  {"sweep sweep.toml --allow-incomplete", 64},
                                                  {"sweep sweep.toml --set spheres.radius=1", 64},
                                                  {"sweep sweep.toml --set seed=x", 64}})
    {
        const Answer answer = run(arguments, "SLURM_ARRAY_TASK_ID=");
        EXPECT_EQ(answer.code, code) << arguments << answer.errors;
    }
    EXPECT_FALSE(isThere("output"));
}

TEST_F(SweepCommand, DryRunsCheckEverythingAndWriteNothing)
{
    const Answer fill = run("fill torus --count 20 --dry-run");
    EXPECT_EQ(fill.code, 0) << fill.errors;
    EXPECT_NE(fill.errors.find("expecting about"), std::string::npos) << fill.errors;
    EXPECT_NE(fill.output.find("nothing was written"), std::string::npos);
    EXPECT_EQ(run("fill torus --radius 90 --dry-run").code, 65);
    EXPECT_EQ(run("fill torus --count 20 --out sweep.toml/in --dry-run").code, 73);
    const Answer sweep = run("sweep sweep.toml --dry-run");
    EXPECT_EQ(sweep.code, 0) << sweep.errors;
    EXPECT_NE(sweep.output.find("8 runs of 8; nothing was written"), std::string::npos)
        << sweep.output;
    EXPECT_FALSE(isThere("output"));

    EXPECT_EQ(run("fill cube --count 8 --size 64x48 --duration 0.5 --quiet --out run").code, 0);
    EXPECT_EQ(run("fill cube --count 8 --out run --dry-run").code, 73); // there is one already
    const Answer render = run("render run --shard 1/4 --dry-run");
    EXPECT_EQ(render.code, 0) << render.errors;
    EXPECT_FALSE(isThere("run/render"));
    EXPECT_EQ(run("render run --frames 5000..6000 --dry-run").code, 64);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "fault/program.hpp"
#include "fault/shown_commands.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::writeFile;

class CommandLine : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    /// Expects this exit code and one line of error that holds `part`.
    void expectRefused(const std::string& arguments, int code, const std::string& part) const
    {
        const Answer answer = run(arguments);
        EXPECT_EQ(answer.code, code) << arguments << "\n" << answer.errors;
        EXPECT_EQ(std::count(answer.errors.begin(), answer.errors.end(), '\n'), 1)
            << arguments << "\n"
            << answer.errors;
        EXPECT_EQ(answer.errors.rfind("frostfill: ", 0), 0u) << answer.errors;
        EXPECT_NE(part, "") << "says nothing of what was wrong";
        EXPECT_NE(answer.errors.find(part), std::string::npos) << arguments << "\n"
                                                               << answer.errors;
        EXPECT_EQ(answer.output, "") << arguments;
    }
    test::TemporaryFolder folder_;
};

TEST_F(CommandLine, HelpOfEveryCommandIsCompleteAndHasExamples)
{
    std::vector<std::string> commands = test::commandsOfHelp(run("--help").output);
    EXPECT_EQ(commands.size(), 12U);
    std::erase(commands, "help");          // its help is that of the program
    commands.insert(commands.begin(), ""); // the program itself
    for (const std::string& command : commands)
    {
        const Answer answer = run(command + " --help");
        EXPECT_EQ(answer.code, 0) << command;
        EXPECT_EQ(answer.errors, "") << command;
        EXPECT_NE(answer.output.find("Usage: frostfill " + command), std::string::npos) << command;
        EXPECT_NE(answer.output.find("--help"), std::string::npos) << command;
        EXPECT_NE(answer.output.find("Examples:\n  frostfill " + command), std::string::npos)
            << command;
    }
}

TEST_F(CommandLine, VersionIsTold)
{
    const Answer answer = run("--version");
    EXPECT_EQ(answer.code, 0);
    EXPECT_EQ(answer.output.rfind("frostfill ", 0), 0u) << answer.output;
}

TEST_F(CommandLine, WrongUseIsRefusedWith64AndOneLine)
{
    expectRefused("", 64, "--help");
    expectRefused("fly", 64, "fly");
    expectRefused("fill", 64, "MESH");
    expectRefused("fill torus --cuont 5", 64, "--count");
    expectRefused("fill torus --count", 64, "--count");
    expectRefused("fill torus --count 0", 64, "--count");
    expectRefused("fill torus --radius abc", 64, "--radius");
    expectRefused("fill torus --radius -1", 64, "--radius");
    expectRefused("fill torus --set motion.restitution=2", 64, "0 to 1");
    expectRefused("fill torus --size 0x0", 64, "--size");
    expectRefused("fill torus --set search.polygons=octree", 64, "quadtree");
    expectRefused("fill torus --preset slow", 64, "paper");
    expectRefused("mesh", 64, "FILE");
}

TEST_F(CommandLine, AValueThatIsEmptyOrGivenTwiceIsRefusedInPlainWords)
{
    expectRefused("fill cube --count 5 --frames none --out ''", 64, "--out is ''");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "output"));
    expectRefused("render '' --out there", 64, "RUN is ''");
    expectRefused("fill cube --count 5 --count 6", 64, "--count is given more than once");
}

TEST_F(CommandLine, NothingIsSuggestedWhereNothingIsNear)
{
    const auto errors = [&](const std::string& arguments) { return run(arguments).errors; };
    EXPECT_EQ(errors("fill cube --bogus"), "frostfill: unexpected argument '--bogus'\n");
    EXPECT_NE(errors("fill cube --cuont 5").find("did you mean --count?"), std::string::npos);
    EXPECT_NE(errors("fill cube --styel dark").find("did you mean --style?"), std::string::npos);
}

// As other programs do, and as a shell expects.
TEST_F(CommandLine, WithoutAReaderItEndsSilentlyBySigpipe)
{
    for (const std::string arguments : {"--help", "help fill", "fill --help-all", "--version",
                                        "mesh torus", "fill cube --count 5 --json --quiet"})
    {
        const Answer answer = test::runProgram("-c '{ sleep 0.3; \"$0\" " + arguments +
                                                   "; } | true; exit ${PIPESTATUS[0]}' "
                                                   "'" FROSTFILL_PROGRAM "'",
                                               folder_.path(), "", "bash");
        EXPECT_EQ(answer.code, 128 + 13) << arguments;
        EXPECT_EQ(answer.errors, "") << arguments;
    }
    EXPECT_TRUE(std::filesystem::exists(folder_ / "output/cube/summary.json"));
    EXPECT_EQ(run("mesh torus | cat >there").code, 0);
}

TEST_F(CommandLine, MissingInputIsRefusedWith66)
{
    expectRefused("fill no-such-file.obj", 66, "no-such-file.obj");
    expectRefused("mesh no-such-file.obj", 66, "no-such-file.obj");
    expectRefused("fill no-such-file.toml", 66, "no-such-file.toml");
    expectRefused("fill no-such-file.json", 66, "no-such-file.json");
}

TEST_F(CommandLine, BadSceneIsRefusedWith65NamingLineAndNearestKey)
{
    writeFile(folder_ / "a.toml", "[spheres]\ncuont = 5\n");
    expectRefused("fill a.toml", 65,
                  "line 2: unknown key 'spheres.cuont'; did you mean "
                  "'spheres.count'?");
    writeFile(folder_ / "b.toml", "seed = \"x\"\n");
    expectRefused("fill b.toml", 65, "line 1");
    writeFile(folder_ / "c.toml", "seed = = 1\n");
    expectRefused("fill c.toml", 65, "line 1");
    writeFile(folder_ / "d.json", "{\"frames\": 3}");
    expectRefused("fill d.json", 65, "d.json");
    writeFile(folder_ / "e.json", "{");
    expectRefused("fill e.json", 65, "e.json");
}

TEST_F(CommandLine, MeshThatCannotBeFilledIsRefusedWith65)
{
    writeFile(folder_ / "empty.obj", "");
    expectRefused("fill empty.obj", 65, "empty.obj");
    writeFile(folder_ / "garbage.stl", "this is no mesh");
    expectRefused("fill garbage.stl", 65, "garbage.stl");
    writeFile(folder_ / "flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expectRefused("fill flat.obj", 65, "flat.obj");
    const Answer flat = run("mesh flat.obj");
    EXPECT_EQ(flat.code, 65);
    EXPECT_NE(flat.output.find("closed      no"), std::string::npos) << flat.output;
}

TEST_F(CommandLine, MeshTellsWhatARadiusCannotReach)
{
    const Answer hands = run("mesh human --radius 0.05");
    EXPECT_EQ(hands.code, 0);
    EXPECT_NE(hands.output.find("is too narrow"), std::string::npos) << hands.output;
    EXPECT_NE(hands.output.find("out of reach: volume"), std::string::npos) << hands.output;
    // The parts that are listed are among what is out of reach, which is less than all.
    const auto numberAfter = [&](const std::string& words, std::size_t from)
    {
        const std::size_t at = hands.output.find(words, from);
        return std::pair(
            at, at == std::string::npos ? 0 : std::stod(hands.output.substr(at + words.size())));
    };
    const double volume = numberAfter("  volume      ", 0).second;
    const double share = numberAfter("reach: at least ", 0).second / 100;
    double listed = 0;
    for (auto [at, part] = numberAfter("out of reach: volume ", 0); at != std::string::npos;
         std::tie(at, part) = numberAfter("out of reach: volume ", at + 1))
    {
        listed += part;
    }
    EXPECT_GT(listed, 0);
    EXPECT_GE(share * volume, 0.99 * listed);
    EXPECT_LT(share, 0.5);
    EXPECT_NE(run("mesh sphere --radius 0.999").output.find("is too narrow"), std::string::npos);
    EXPECT_NE(run("mesh sphere --radius 1.1").output.find("no sphere"), std::string::npos);
    EXPECT_EQ(run("mesh sphere --radius 0").code, 64);
}

TEST_F(CommandLine, MeshTellsWhatItFoundAndWritesTheRepair)
{
    const Answer answer = run("mesh torus --repair out.ply");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.output.find("1152 triangles"), std::string::npos) << answer.output;
    EXPECT_NE(answer.output.find("can be filled"), std::string::npos);
    EXPECT_EQ(run("mesh out.ply").code, 0);
    EXPECT_EQ(run("mesh torus --repair no/such/folder/out.ply").code, 73);
}

TEST_F(CommandLine, FullStandardOutputIsAFailedWrite)
{
    EXPECT_EQ(run("mesh torus >/dev/full").code, 74);
}

TEST_F(CommandLine, DoctorTellsVersionsAndOpenGl)
{
    const Answer answer = run("doctor");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    for (const char* part : {"Eigen", "assimp", "OpenGL", "ffmpeg", "python3"})
    {
        EXPECT_NE(answer.output.find(part), std::string::npos) << part << "\n" << answer.output;
    }
}

} // namespace
} // namespace frostfill

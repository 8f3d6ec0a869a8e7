// SPDX-License-Identifier: MIT
// What helps to use the program: help, version, the completion, and suggestions.
#include "fault/program.hpp"
#include "fault/shown_commands.hpp"
#include "support/paths.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;
using test::writeFile;

const std::filesystem::path kCompletion =
    testing_support::sourceFolder() / "src/app/frostfill.bash";

class HelpCommands : public ::testing::Test
{
protected:
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path());
    }
    [[nodiscard]] Answer runOther(const std::string& program, const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path(), "", program);
    }
    /// What bash offers for the last of these words.
    [[nodiscard]] std::string completed(const std::string& words) const
    {
        writeFile(folder_ / "ask.bash", "compopt() { :; }\nPATH=$(dirname '" FROSTFILL_PROGRAM
                                        "'):$PATH\nsource '" +
                                            kCompletion.string() + "'\nCOMP_WORDS=(" + words +
                                            ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n"
                                            "_frostfill\necho \"${COMPREPLY[@]}\"\n");
        const Answer answer = runOther("bash", "--norc ask.bash");
        EXPECT_EQ(answer.errors, "");
        return answer.output;
    }
    test::TemporaryFolder folder_;
};

TEST_F(HelpCommands, HelpOfACommandIsThatOfItsOption)
{
    EXPECT_EQ(run("help fill").output, run("fill --help").output);
    EXPECT_EQ(run("help").output, run("--help").output);
    const Answer wrong = run("help fil");
    EXPECT_EQ(wrong.code, 64);
    EXPECT_NE(wrong.errors.find("did you mean fill?"), std::string::npos) << wrong.errors;
}

TEST_F(HelpCommands, AMistypedCommandIsToldTheNearestOne)
{
    for (const auto& [words, nearest] : {std::pair{"fil torus", "fill"}, {"mehs torus", "mesh"}})
    {
        const Answer answer = run(words);
        EXPECT_EQ(answer.code, 64) << words;
        EXPECT_NE(answer.errors.find("did you mean " + std::string(nearest) + "?"),
                  std::string::npos)
            << answer.errors;
    }
    EXPECT_NE(run("xyzzy").errors.find("no command 'xyzzy'"), std::string::npos);
}

/// Lines that begin with an option.
std::vector<std::string> optionLines(const std::string& help)
{
    std::vector<std::string> lines;
    std::istringstream text(help);
    for (std::string line; std::getline(text, line);)
    {
        if (line.starts_with("  --"))
        {
            lines.push_back(line);
        }
    }
    return lines;
}

TEST_F(HelpCommands, HelpIsShortAndHasALineForEachOption)
{
    const auto lines = [](const std::string& text)
    { return std::count(text.begin(), text.end(), '\n'); };
    const std::string program = run("--help").output;
    EXPECT_LE(lines(program), 40) << program;
    const std::string fill = run("fill --help").output;
    EXPECT_LE(lines(fill), 70) << fill;
    for (const char* group :
         {"Object", "Spheres", "Motion", "Rest", "Pictures", "Camera", "Output"})
    {
        EXPECT_NE(fill.find("\n" + std::string(group) + ":\n"), std::string::npos) << group;
    }
    const std::vector<std::string> options = optionLines(fill);
    EXPECT_LE(options.size(), 40U + 2) << "and those that print help";
    EXPECT_GE(options.size(), 30U);
    for (const std::string& line : options)
    {
        EXPECT_LE(line.size(), 120U) << line;
        EXPECT_GT(line.size(), 42U) << line;
    }
    for (const std::string& command : test::commandsOfHelp(program))
    {
        EXPECT_LE(lines(run(command + " --help").output), 70) << command;
    }
}

TEST_F(HelpCommands, AllOfAHelpHasEveryKeyThatTheCommandTakes)
{
    const auto hasKey = [](const std::string& text, const std::string& key)
    { return text.find("\n  " + key + " ") != std::string::npos; };
    const std::string fill = run("fill --help-all").output;
    const std::string page = readFile(testing_support::sourceFolder() / "docs/options.md");
    const std::regex row("\n\\| `([a-z_.]+)` \\|");
    std::size_t keys = 0;
    for (std::sregex_iterator key(page.begin(), page.end(), row), end; key != end; ++key, ++keys)
    {
        EXPECT_TRUE(hasKey(fill, (*key)[1])) << (*key)[1];
    }
    EXPECT_GT(keys, 85U);
    const std::string check = run("check --help-all").output;
    EXPECT_TRUE(hasKey(check, "judge.friction") && hasKey(check, "object.up"));
    EXPECT_FALSE(hasKey(check, "spheres.count"));
    EXPECT_NE(run("--help-all").output.find(fill.substr(0, 500)), std::string::npos);
}

TEST_F(HelpCommands, SetTakesEveryKeyWithTheWordsOfSceneFiles)
{
    const std::string small = "fill cube --frames none --quiet --overwrite --out run ";
    ASSERT_EQ(run(small + "--set spheres.count=7 --set seed=3 --set motion.mode=skip "
                          "--set search.neighbour_lists=false")
                  .code,
              0);
    const auto scene = nlohmann::json::parse(readFile(folder_ / "run/summary.json"))["scene"];
    EXPECT_EQ(scene["spheres"]["count"], 7);
    EXPECT_EQ(scene["seed"], 3);
    EXPECT_EQ(scene["motion"]["mode"], "skip");
    EXPECT_EQ(scene["search"]["neighbour_lists"], false);
    const std::vector<std::pair<std::string, std::string>> wrong = {
        {"--set spheres.cuont=5", "unknown key 'spheres.cuont'; did you mean 'spheres.count'?"},
        {"--set motion.dt=0", "motion.dt is '0', but it must be a number from 1e-12 to 1000000"},
        {"--set search.polygons=quodtree", "did you mean 'quadtree'?"},
        {"--set motion.dt", "--set motion.dt has no value: give --set KEY=VALUE"},
        {"--set motion.dt=", "has no value"},
        {"--count 5 --set spheres.count=5", "given twice, as --count and as spheres.count"},
        {"--set seed=1 --set seed=2", "seed is given twice"},
        {"--set object.mesh=torus", "as MESH and as object.mesh"},
    };
    for (const auto& [arguments, says] : wrong)
    {
        const Answer answer = run(small + arguments);
        EXPECT_EQ(answer.code, 64) << arguments;
        EXPECT_NE(answer.errors.find(says), std::string::npos) << arguments << answer.errors;
    }
    const Answer mesh = run("mesh cube --set spheres.count=5");
    EXPECT_EQ(mesh.code, 64);
    EXPECT_NE(mesh.errors.find("mesh does not use the key spheres.count"), std::string::npos);
    EXPECT_EQ(run("fill --set object.mesh=cube --set spheres.count=4 --frames none --out b").code,
              0);
    EXPECT_EQ(run("fill a.toml --set object.mesh=cube").code, 66);
    EXPECT_EQ(run("mesh cube --set object.lid=true").code, 0);
}

TEST_F(HelpCommands, AnOldFlagIsRefusedWithTheNewWay)
{
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"fill cube --discard-epsilon 4",
         "--discard-epsilon is a key of the scene: --set discard.epsilon=4"},
        {"fill cube --dt=0.01", "--dt is a key of the scene: --set motion.dt=0.01"},
        {"fill cube --unite", "--unite is a key of the scene: --set object.unite=true"},
        {"fill cube --no-neighbour-lists",
         "--no-neighbour-lists is a key of the scene: --set search.neighbour_lists=false"},
        {"fill cube --freeze-by-set", "--set freezing.rule=by-set"},
        {"fill cube --max-frames", "--set frames.limit=VALUE"},
        {"fill --scene a.toml", "give the scene in place of MESH"},
        {"fill cube --view", "--out FILE.html"},
        {"fill cube --export vtp", "frostfill export RUN --to FORMAT"},
        {"check pile.csv --judge-friction 0.3", "--set judge.friction=0.3"},
        {"view run --output a.html", "--output is now --out"},
        {"render run --json-progress 2", "--json-progress is gone"},
    };
    for (const auto& [arguments, says] : cases)
    {
        const Answer answer = run(arguments);
        EXPECT_EQ(answer.code, 64) << arguments;
        EXPECT_NE(answer.errors.find(says), std::string::npos) << arguments << answer.errors;
    }
    // What another command has is no old flag there.
    EXPECT_EQ(run("analyse nothing.csv --threads 2").code, 66);
}

TEST_F(HelpCommands, WhatFollowsFromAnOptionIsSaidInALine)
{
    const std::string grains = "fill cube --count 12 --frames none --out run --overwrite ";
    const Answer granular = run(grains + "--motion granular --friction 0.3");
    EXPECT_EQ(granular.code, 0) << granular.errors;
    EXPECT_NE(granular.errors.find("frostfill: --motion granular implies --rest joint\n"),
              std::string::npos)
        << granular.errors;
    const Answer fraction =
        run("fill cube --radius 0.1 --count 200 --fraction 0.6 --friction 0.3 --dry-run");
    EXPECT_EQ(fraction.code, 0) << fraction.errors;
    EXPECT_NE(fraction.errors.find("frostfill: --fraction implies --rest joint\n"),
              std::string::npos)
        << fraction.errors;
    const Answer alone = run("fill cube --radius 0.1 --count 200 --fraction 0.6 --dry-run");
    EXPECT_EQ(alone.code, 0) << alone.errors;
    EXPECT_NE(alone.errors.find("frostfill: --fraction implies --rest joint and --friction 0.3\n"),
              std::string::npos)
        << alone.errors;
    const Answer held = run("fill cube --radius 0.1 --rest joint --fraction loosest "
                            "--motion granular --dry-run");
    EXPECT_NE(held.errors.find("frostfill: --fraction implies --friction 0.3\n"), std::string::npos)
        << held.errors;
    EXPECT_EQ(run("fill cube --radius 0.1 --fraction densest --dry-run").errors.find("friction"),
              std::string::npos);
    EXPECT_EQ(run("fill cube --radius 0.1 --fraction 0.6 --friction 0 --dry-run").code, 64);
    EXPECT_EQ(run(grains + "--motion granular --rest each").code, 64);
    EXPECT_EQ(run(grains + "--rest joint --friction 0.3").errors.find("implies"),
              std::string::npos);
    writeFile(folder_ / "grains.toml", "motion.mode = \"granular\"\nspheres.count = 12\n"
                                       "[frames]\nwhich = \"none\"\n");
    EXPECT_EQ(run("fill grains.toml --quiet --out file").code, 0);
}

TEST_F(HelpCommands, BashCompletesCommandsOptionsWordsAndKeys)
{
    EXPECT_EQ(completed("frostfill fil"), "fill\n");
    EXPECT_EQ(completed("frostfill mesh torus --re"), "--repair\n");
    EXPECT_EQ(completed("frostfill fill --motion ''"), "fall skip descend granular\n");
    EXPECT_EQ(completed("frostfill fill torus --set spheres.group"),
              "spheres.group_size= spheres.groups_per_set=\n");
    EXPECT_EQ(completed("frostfill check --set spheres.group"), "\n");
}

} // namespace
} // namespace frostfill

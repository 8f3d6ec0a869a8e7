// SPDX-License-Identifier: MIT
// What helps to use the program: help, version, manual pages, completions, and suggestions.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;
using test::writeFile;

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
    [[nodiscard]] bool isThere(const std::string& program) const
    {
        return runOther("which", program).code == 0;
    }
    /// What bash offers for the last of these words.
    [[nodiscard]] std::string completed(const std::string& words) const
    {
        writeFile(folder_ / "ask.bash", "source completion.bash\nCOMP_WORDS=(" + words +
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
    EXPECT_EQ(run("help bench error").output, run("bench error --help").output);
    EXPECT_EQ(run("help").output, run("--help").output);
    EXPECT_EQ(run("version").output, run("--version").output);
    const Answer wrong = run("help fil");
    EXPECT_EQ(wrong.code, 64);
    EXPECT_NE(wrong.errors.find("did you mean fill?"), std::string::npos) << wrong.errors;
}

TEST_F(HelpCommands, AMistypedCommandIsToldTheNearestOne)
{
    for (const auto& [words, nearest] :
         {std::pair{"fil torus", "fill"}, {"bench eror", "error"}, {"mehs torus", "mesh"}})
    {
        const Answer answer = run(words);
        EXPECT_EQ(answer.code, 64) << words;
        EXPECT_NE(answer.errors.find("did you mean " + std::string(nearest) + "?"),
                  std::string::npos)
            << answer.errors;
    }
    EXPECT_NE(run("xyzzy").errors.find("no command 'xyzzy'"), std::string::npos);
}

TEST_F(HelpCommands, ThereIsAManualPageForEveryCommandWithEachOfItsOptions)
{
    ASSERT_EQ(run("man pages").code, 0);
    const std::string all = readFile(folder_ / "pages/frostfill.1");
    std::size_t pages = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "pages"))
    {
        ++pages;
        const std::string name = entry.path().stem().string();
        if (name == "frostfill")
        {
            continue;
        }
        std::string command = name.substr(std::string("frostfill-").size());
        std::replace(command.begin(), command.end(), '-', ' ');
        const std::string help = run(command + " --help").output;
        std::string page = readFile(entry.path());
        page = std::regex_replace(page, std::regex(R"(\\-)"), "-");
        const std::regex option("--[a-z][a-z0-9-]*");
        for (std::sregex_iterator found(help.begin(), help.end(), option), end; found != end;
             ++found)
        {
            EXPECT_NE(page.find(found->str()), std::string::npos) << name << " " << found->str();
        }
        if (isThere("groff"))
        {
            const Answer formatted = runOther("groff", "-man -ww -z " + entry.path().string());
            EXPECT_EQ(formatted.errors, "") << name;
        }
    }
    EXPECT_GT(pages, 10U);
}

TEST_F(HelpCommands, BashCompletesCommandsOptionsAndWords)
{
    ASSERT_EQ(run("completion bash > completion.bash").code, 0);
    EXPECT_EQ(completed("frostfill fil"), "fill\n");
    EXPECT_EQ(completed("frostfill bench err"), "error\n");
    EXPECT_EQ(completed("frostfill fill torus --group"), "--group-size --groups-per-set\n");
    EXPECT_EQ(completed("frostfill fill --motion ''"), "fall skip descend granular\n");
    EXPECT_EQ(completed("frostfill mesh torus --re"), "--repair\n");
}

TEST_F(HelpCommands, OtherShellsReadTheirCompletions)
{
    for (const char* shell : {"zsh", "fish"})
    {
        const std::string file = std::string("completion.") + shell;
        ASSERT_EQ(run(std::string("completion ") + shell + " > " + file).code, 0);
        const std::string option = shell == std::string("fish") ? "-l motion" : "--motion";
        EXPECT_NE(readFile(folder_ / file).find(option), std::string::npos);
        if (isThere(shell))
        {
            EXPECT_EQ(runOther(shell, "-n " + file).errors, "");
        }
    }
    EXPECT_EQ(run("completion tcsh").code, 64);
}

} // namespace
} // namespace frostfill

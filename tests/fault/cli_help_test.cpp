// SPDX-License-Identifier: MIT
// What helps to use the program: help, version, the completion, and suggestions.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <string>

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
    EXPECT_EQ(run("help").output, run("--help").output);
    EXPECT_EQ(run("version").output, run("--version").output);
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

TEST_F(HelpCommands, BashCompletesCommandsOptionsAndWords)
{
    ASSERT_EQ(run("completion bash > completion.bash").code, 0);
    EXPECT_EQ(completed("frostfill fil"), "fill\n");
    EXPECT_EQ(completed("frostfill fill torus --group"), "--group-size --groups-per-set\n");
    EXPECT_EQ(completed("frostfill fill --motion ''"), "fall skip descend granular\n");
    EXPECT_EQ(completed("frostfill mesh torus --re"), "--repair\n");
}

TEST_F(HelpCommands, BashOffersNoWordThatTheProgramRefuses)
{
    ASSERT_EQ(run("completion bash > completion.bash").code, 0);
    EXPECT_EQ(completed("frostfill fill --cutaway ''"), "none\n");
    EXPECT_EQ(completed("frostfill fill --sizes ''"), "none\n");
    const std::string script = readFile(folder_ / "completion.bash");
    const std::regex choice("'fill,(--[a-z-]+)'\\) words='([^']*)'");
    std::size_t words = 0;
    for (std::sregex_iterator found(script.begin(), script.end(), choice), end; found != end;
         ++found)
    {
        std::istringstream list((*found)[2].str());
        for (std::string word; list >> word; ++words)
        {
            const std::string arguments = "fill missing.stl " + (*found)[1].str() + " " + word;
            const Answer answer = run(arguments);
            EXPECT_EQ(answer.errors.find("must be"), std::string::npos) << answer.errors;
        }
    }
    EXPECT_GT(words, 60U);
    EXPECT_EQ(run("completion zsh").code, 64);
}

TEST_F(HelpCommands, TheOptionsPageShowsWholeValues)
{
    const std::string page = run("options").output;
    EXPECT_NE(page.find("`--searches A,B,...`"), std::string::npos);
    EXPECT_NE(page.find("`--shard I/N\\|slurm`"), std::string::npos);
    EXPECT_EQ(page.find("INT in ["), std::string::npos);
}

} // namespace
} // namespace frostfill

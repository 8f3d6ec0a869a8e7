// SPDX-License-Identifier: MIT
#include "lab/program_talk.hpp"

#include "support/small_program.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

namespace frostfill
{
namespace
{

using namespace std::chrono_literals;
using test::writeProgram;

constexpr double kLong = 60; // no test waits for so long [s]

/// What it repeats, it reads all of first.
constexpr const char* kEcho = "while read -r line; do echo \"$line\"; done\n";

class Talks : public testing::Test
{
protected:
    [[nodiscard]] std::string program(const std::string& script) const
    {
        return writeProgram(folder_ / "program", script);
    }
    /// Until it holds, or for ten seconds.
    template <typename Condition>
    [[nodiscard]] static bool comesTrue(Condition condition)
    {
        for (int k = 0; k < 1000 && !condition(); ++k)
        {
            std::this_thread::sleep_for(10ms);
        }
        return condition();
    }
    [[nodiscard]] bool waitForNumber() const
    {
        return comesTrue([&] { return test::readFile(folder_ / "pid").ends_with('\n'); });
    }
    [[nodiscard]] bool endsWithoutTrace() const
    {
        return comesTrue([&] { return !test::runs(folder_ / "pid"); });
    }
    test::TemporaryFolder folder_;
};

TEST_F(Talks, GoLineByLine)
{
    ProgramTalk talk(program(kEcho), kLong);
    ASSERT_EQ(talk.error(), 0);
    talk.say("one\ntwo");
    talk.say(" and a half\n");
    EXPECT_EQ(talk.hear(), "one");
    EXPECT_EQ(talk.hear(), "two and a half");
}

TEST_F(Talks, NeedNoAnswerHoweverMuchIsSaid)
{
    ProgramTalk talk(program("wc -l\n"), kLong);
    for (int k = 0; k < 200000; ++k)
    {
        talk.say("a line that fills pipes\n");
    }
    talk.end();
    EXPECT_EQ(talk.hear(), "200000"); // what it said at its end can be heard
    EXPECT_EQ(talk.hear(), std::nullopt);
}

TEST_F(Talks, AreNoDeadlockWhenBothPipesAreFull)
{
    // It says more than a pipe takes before it reads, and complains as much.
    ProgramTalk talk(program("awk 'BEGIN { for (k = 0; k < 9000; ++k) print \"before\" }'\n"
                             "awk 'BEGIN { for (k = 0; k < 9000; ++k) print \"trouble\" }' >&2\n"
                             "wc -c\n"),
                     kLong);
    talk.say(std::string(500000, '-') + "\n");
    for (int k = 0; k < 9000; ++k)
    {
        ASSERT_EQ(talk.hear(), "before") << k;
    }
    talk.end();
    EXPECT_LE(talk.errors().size(), 400U);
    EXPECT_TRUE(talk.errors().ends_with("trouble\n")) << talk.errors();
}

TEST_F(Talks, WaitForAnAnswerThatComesInPieces)
{
    ProgramTalk talk(program("for word in a long answer; do printf %s $word; sleep 0.02; done\n"
                             "echo; sleep 60\n"),
                     kLong);
    EXPECT_EQ(talk.hear(), "alonganswer");
}

TEST_F(Talks, EndWithAProgramThatSaysWhatNobodyAskedFor)
{
    ProgramTalk lines(program("yes\n"), kLong);
    lines.say(std::string(1 << 20, '-'));
    EXPECT_EQ(lines.hear(), "y");
    ProgramTalk noLine(program("head -c 1000000 /dev/zero; sleep 60\n"), 5);
    EXPECT_EQ(noLine.hear(), std::nullopt);
    EXPECT_EQ(noLine.ending(), "says more than it was asked for");
}

TEST_F(Talks, EndWithTheProgram)
{
    ProgramTalk broken(program("echo first; echo 'no such mesh' >&2; exit 3\n"), kLong);
    EXPECT_EQ(broken.hear(), "first");
    EXPECT_EQ(broken.hear(), std::nullopt);
    EXPECT_EQ(broken.ending(), "ended with code 3");
    EXPECT_EQ(broken.errors(), "no such mesh\n");
    ProgramTalk crashed(program("kill -SEGV $$\n"), kLong);
    EXPECT_EQ(crashed.hear(), std::nullopt);
    EXPECT_EQ(crashed.ending(), "was ended by signal 11");
}

TEST_F(Talks, WithAProgramThatIsGoneRaiseNoSignal)
{
    ProgramTalk talk(program("exec <&-; echo gone; sleep 60\n"), kLong);
    EXPECT_EQ(talk.hear(), "gone");
    std::signal(SIGPIPE, SIG_DFL);
    for (int k = 0; k < 3; ++k)
    {
        talk.say(std::string(1 << 17, '-')); // more than a pipe takes
    }
    sigset_t waiting;
    sigpending(&waiting);
    EXPECT_EQ(sigismember(&waiting, SIGPIPE), 0);
}

TEST_F(Talks, EndWhenAProgramHangs)
{
    ProgramTalk talk(program("sleep 60\n"), 0.2);
    EXPECT_EQ(talk.hear(), std::nullopt);
    EXPECT_EQ(talk.ending(), "has not answered within 0.2 s");
    ProgramTalk deaf(program("sleep 60\n"), 0.2);
    deaf.say(std::string(1 << 20, '-')); // which it does not read
    EXPECT_EQ(deaf.hear(), std::nullopt);
    EXPECT_EQ(deaf.ending(), "has not answered within 0.2 s");
}

TEST_F(Talks, LeaveNothingBehind)
{
    const std::size_t before = test::openDescriptors();
    {
        // A script whose engine runs beside it.
        ProgramTalk talk(
            program("sleep 60 & echo $! >'" + (folder_ / "pid").string() + "'; echo ready; wait\n"),
            kLong);
        EXPECT_EQ(talk.hear(), "ready");
        EXPECT_TRUE(test::runs(folder_ / "pid"));
        EXPECT_GT(test::openDescriptors(), before);
    }
    EXPECT_TRUE(endsWithoutTrace());
    EXPECT_EQ(test::openDescriptors(), before);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1); // no zombie
    EXPECT_EQ(errno, ECHILD);
    {
        const ProgramTalk missing((folder_ / "missing").string(), kLong);
        EXPECT_EQ(missing.error(), ENOENT);
    }
    EXPECT_EQ(test::openDescriptors(), before);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

TEST_F(Talks, EndWithTheProcessThatIsKilled)
{
    const std::string name =
        program("echo $$ >'" + (folder_ / "pid").string() + "'; exec sleep 60\n");
    const pid_t parent = fork();
    if (parent == 0)
    {
        ProgramTalk talk(name, kLong);
        static_cast<void>(talk.hear());
        _exit(0);
    }
    EXPECT_TRUE(waitForNumber());
    EXPECT_TRUE(test::runs(folder_ / "pid"));
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    EXPECT_TRUE(endsWithoutTrace());
}

TEST_F(Talks, CountTheProcessorTimeOfTheProgramAndNotItsSleep)
{
    // `times` of the shell is a second account: its own time, then that of what it has waited for.
    const std::string script = "echo ready; read -r line\n"
                               "k=0; while [ $k -lt 300000 ]; do k=$((k + 1)); done; sleep 0.3\n"
                               "awk 'BEGIN { for (k = 0; k < 3000000; ++k) ++sum }'\n"
                               "times; read -r line\n";
    ProgramTalk talk(program(script), kLong);
    EXPECT_EQ(talk.hear(), "ready");
    const double start = talk.seconds();
    talk.say("go\n");
    double total = 0;
    double own = 0;
    for (int row = 0; row < 2; ++row)
    {
        const std::string line = talk.hear().value_or("");
        int minutes[2] = {};
        double seconds[2] = {};
        ASSERT_EQ(std::sscanf(line.c_str(), "%dm%lfs %dm%lfs", &minutes[0], &seconds[0],
                              &minutes[1], &seconds[1]),
                  4)
            << line;
        total += 60 * (minutes[0] + minutes[1]) + seconds[0] + seconds[1];
        own = row == 0 ? total : own;
    }
    EXPECT_GT(own, 0);
    EXPECT_GT(total, own);
    EXPECT_LT(start, own);
    EXPECT_NEAR(talk.seconds(), own, 0.03); // what it has started counts once it has ended
    talk.end();
    EXPECT_NEAR(talk.seconds(), total, 0.03);
}

TEST_F(Talks, FindAProgramByItsPathOrInPath)
{
    ProgramTalk cat("cat", kLong);
    ASSERT_EQ(cat.error(), 0);
    cat.say("hello\n");
    EXPECT_EQ(cat.hear(), "hello");
    test::writeFile(folder_ / "text", "no program\n");
    EXPECT_EQ(ProgramTalk((folder_ / "text").string(), kLong).error(), EACCES);
    EXPECT_EQ(ProgramTalk(folder_.path().string(), kLong).error(), EACCES);
}

} // namespace
} // namespace frostfill

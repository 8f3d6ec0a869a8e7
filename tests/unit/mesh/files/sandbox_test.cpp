// SPDX-License-Identifier: MIT
#include "mesh/files/sandbox.hpp"

#include "base/resources.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;

constexpr SandboxLimits kSmall = {std::size_t{256} << 20, 1};

std::string run(const std::function<std::string()>& work)
{
    std::string result; // of the child's own
    const SandboxedBytes bytes = runSandboxed(kSmall, "'x.ply' cannot be read",
                                              [&]() -> SandboxReport
                                              {
                                                  result = work();
                                                  const std::string_view all = result;
                                                  const std::size_t half = all.size() / 2;
                                                  return {all.substr(0, half), all.substr(half)};
                                              });
    return std::string(bytes.view());
}

TEST(Sandbox, ReturnsWhatTheWorkReturns)
{
    const std::string bytes(300'000, '\x7f'); // more than a pipe holds
    EXPECT_EQ(run([&] { return bytes; }), bytes);
    EXPECT_EQ(run([] { return std::string(); }), "");
}

TEST(Sandbox, ThrowsWhatTheWorkThrows)
{
    expectError(
        ErrorCode::inputMissing,
        [] { (void)run([]() -> std::string { throw Error(ErrorCode::inputMissing, "no file"); }); },
        "no file");
}

TEST(Sandbox, TellsACrashInASentence)
{
    expectError(
        ErrorCode::badData, [] { (void)run([]() -> std::string { std::abort(); }); },
        "'x.ply' cannot be read", "crashed", "Aborted");
    expectError(
        ErrorCode::badData, [] { (void)run([]() -> std::string { _exit(3); }); }, "gave up");
}

TEST(Sandbox, EndsWhatNeverEnds)
{
    expectError(
        ErrorCode::badData,
        []
        {
            (void)run(
                []() -> std::string
                {
                    volatile bool ends = false;
                    while (!ends)
                    {
                    }
                    return {};
                });
        },
        "more than 1 s of processor time");
}

TEST(Sandbox, RefusesWhatTakesAllMemory)
{
#ifdef FROSTFILL_SANITIZED
    GTEST_SKIP() << "sanitizers map more memory than any limit allows";
#endif
    expectError(
        ErrorCode::badData,
        [] { (void)run([] { return std::string(std::size_t{1} << 30, 'x'); }); },
        "more than 256 MB of memory");
}

TEST(Sandbox, WritesToNoFileAndOpensFew)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW((void)run(
                     [&]
                     {
                         std::ofstream(folder / "written") << "something" << std::flush;
                         return std::string();
                     }),
                 Error);
    EXPECT_EQ(test::readFile(folder / "written"), "");
    const std::string opened = run(
        [&]
        {
            std::vector<std::ifstream> files;
            std::size_t open = 0;
            for (int i = 0; i < 100; ++i)
            {
                open += files.emplace_back(folder / "written").is_open() ? 1 : 0;
            }
            return std::to_string(open);
        });
    EXPECT_LT(std::stoi(opened), 16);
    EXPECT_GT(std::stoi(opened), 0);
}

TEST(Sandbox, JoinsWhatTheWorkSendsInParts)
{
    std::vector<std::uint64_t> numbers; // more than a pipe holds at once
    const std::string text = "end";
    const SandboxedBytes bytes =
        runSandboxed(kSmall, "'x.ply' cannot be read",
                     [&]() -> SandboxReport
                     {
                         for (std::uint64_t i = 0; i < 300'000; ++i)
                         {
                             numbers.push_back(i * i);
                         }
                         return {{reinterpret_cast<const char*>(numbers.data()),
                                  numbers.size() * sizeof numbers[0]},
                                 {},
                                 text};
                     });
    EXPECT_TRUE(numbers.empty()) << "filled in the child only";
    ASSERT_EQ(bytes.size, 8U * 300'000 + text.size());
    for (std::uint64_t i = 0; i < 300'000; ++i)
    {
        std::uint64_t number = 0;
        std::memcpy(&number, bytes.bytes.get() + 8 * i, sizeof number);
        ASSERT_EQ(number, i * i);
    }
    EXPECT_EQ(bytes.view().substr(8U * 300'000), text);
}

TEST(Sandbox, TakesNoMoreThanTheChildMayUse)
{
    const std::string part(1 << 20, 'x');
    expectError(
        ErrorCode::badData,
        [&] {
            (void)runSandboxed(kSmall, "'x.ply' cannot be read",
                               [&] { return SandboxReport(257, part); });
        },
        "'x.ply' cannot be read: it needs more than 256 MB of memory");
    EXPECT_EQ(runSandboxed(kSmall, "", [&] { return SandboxReport(2, part); }).size, 2U << 20);
}

TEST(Sandbox, KeepsAStricterLimitOfItsParent)
{
    rlimit before = {};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit strict = {7, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &strict), 0);
    const std::string seen = run(
        []
        {
            rlimit now = {};
            getrlimit(RLIMIT_NOFILE, &now);
            return std::to_string(now.rlim_cur);
        });
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_EQ(seen, "7");
}

TEST(Sandbox, TellsAKillFromALimit)
{
    expectError(
        ErrorCode::badData,
        [] { (void)run([]() -> std::string { return std::to_string(raise(SIGKILL)); }); },
        "the reader was killed, as by a system whose memory is used up");
    expectError(
        ErrorCode::badData,
        []
        {
            (void)runSandboxed({kSmall.bytes, 0}, "'x.ply' cannot be read",
                               []() -> SandboxReport
                               {
                                   std::this_thread::sleep_for(std::chrono::minutes(2));
                                   return {};
                               });
        },
        "it takes more than 0 s");
}

TEST(Sandbox, WorksInThisProcessBesideOtherThreads)
{
    std::atomic<bool> over = false;
    std::thread other([&] { over.wait(false); });
    pid_t id = 0;
    const std::string bytes = run(
        [&]
        {
            id = getpid();
            return std::string("work");
        });
    EXPECT_THROW((void)run([]() -> std::string { throw Error(ErrorCode::badData, "bad"); }), Error);
    over = true;
    over.notify_all();
    other.join();
    EXPECT_EQ(bytes, "work");
    EXPECT_EQ(id, getpid());
}

TEST(Sandbox, LeavesNothingBehind)
{
    const std::string own = "parent";
    std::string seen = own;
    EXPECT_EQ(run(
                  [&]
                  {
                      seen = "child";
                      return seen;
                  }),
              "child");
    EXPECT_EQ(seen, own) << "the work is done in a process of its own";
}

} // namespace
} // namespace frostfill

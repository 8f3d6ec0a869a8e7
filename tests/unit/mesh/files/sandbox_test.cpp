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
    return runSandboxed(kSmall, "'x.ply' cannot be read",
                        [&] {
                            return ReadResult{{}, work()};
                        })
        .remarks;
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

TEST(Sandbox, ReturnsTheMeshOfTheWork)
{
    TriangleMesh mesh; // more than a pipe holds at once
    const ReadResult result = runSandboxed(kSmall, "'x.ply' cannot be read",
                                           [&]
                                           {
                                               for (std::uint32_t i = 0; i < 100'000; ++i)
                                               {
                                                   mesh.vertices.emplace_back(i, 0.5 * i, -1.0 * i);
                                                   mesh.triangles.push_back({i, i + 1, i + 2});
                                               }
                                               return ReadResult{mesh, "end"};
                                           });
    EXPECT_TRUE(mesh.vertices.empty()) << "filled in the child only";
    ASSERT_EQ(result.mesh.vertices.size(), 100'000U);
    ASSERT_EQ(result.mesh.triangles.size(), 100'000U);
    for (std::uint32_t i = 0; i < 100'000; ++i)
    {
        ASSERT_EQ(result.mesh.vertices[i], Eigen::Vector3d(i, 0.5 * i, -1.0 * i));
        ASSERT_EQ(result.mesh.triangles[i], (std::array{i, i + 1, i + 2}));
    }
    EXPECT_EQ(result.remarks, "end");
}

TEST(Sandbox, TakesNoMoreThanTheChildMayUse)
{
    // What the parent has is beyond the child's limit, and is sent as it is.
    std::string text(257 << 20, 'x');
    expectError(
        ErrorCode::badData,
        [&]
        {
            (void)runSandboxed(kSmall, "'x.ply' cannot be read",
                               [&] {
                                   return ReadResult{{}, std::string(text)};
                               });
        },
        "'x.ply' cannot be read: it needs more than 256 MB of memory");
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
                               []() -> ReadResult
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

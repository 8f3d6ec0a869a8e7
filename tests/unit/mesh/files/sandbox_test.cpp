// SPDX-License-Identifier: MIT
#include "mesh/files/sandbox.hpp"

#include "base/sanitized.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;

constexpr SandboxLimits kSmall = {std::size_t{256} << 20, 1};

std::string run(const std::function<std::string()>& work)
{
    return runSandboxed(kSmall, "'x.ply' cannot be read", work);
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

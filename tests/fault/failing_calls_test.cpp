// SPDX-License-Identifier: MIT
// One call of the program fails, then the next: each open, write, fsync, close and rename of a file
// of a run, and each allocation. Rows F3, F4 and F5 of docs/reliability.md.
#include "fault/failing_calls.hpp"

#include <set>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::FailingCalls;
using test::Failure;
using test::kTiny;
using test::readFile;
namespace fs = std::filesystem;

// ENOSPC 28, EIO 5, EACCES 13, EINTR 4.
TEST_F(FailingCalls, LeaveNoCorruptFileAndNoFalseSuccess)
{
    expectEachIsBorne(
        {{"open", "28"}, {"write", "28"}, {"fsync", "5"}, {"close", "5"}, {"rename", "13"}});
}

TEST_F(FailingCalls, WhileAPictureIsDrawnEndTheRunInOrder)
{
    ASSERT_EQ(run(kTiny + "--out whole").code, 0);
    const auto whole = contents("whole");
    int failures = 0;
    for (int at = 20; at < 60; ++at)
    {
        fs::remove_all(folder_ / "faulty");
        const Answer answer = runWith({"write", "28"}, at, kTiny + "--out faulty");
        const std::string what = fmt::format("write {}", at);
        expectNothingIsCorrupt(answer, whole, what);
        EXPECT_EQ(answer.code, hasFailed() ? 74 : 0) << what << ": " << answer.errors;
        failures += hasFailed() ? 1 : 0;
    }
    EXPECT_GT(failures, 20);
}

TEST_F(FailingCalls, AreInvisibleWhenOnlyInterruptedOrShort)
{
    expectEachIsBorne({{"open", "4"}, {"write", "4"}, {"write", "short"}, {"fsync", "4"}});
}

TEST_F(FailingCalls, OfEveryKindLeaveNoCorruptFile) // with the label `long`
{
    std::vector<Failure> all;
    for (const char* call : {"open", "write", "fsync", "close", "rename"})
    {
        for (const char* how : {"28", "5", "13"})
        {
            all.push_back({call, how, false});
            all.push_back({call, how, true});
        }
    }
    expectEachIsBorne(all, true);
    expectEachIsBorne({{"open", "4"}, {"write", "4"}, {"write", "short"}, {"fsync", "4"}}, true);
}

TEST_F(FailingCalls, WhatAKillLeavesTheNextRunClearsAway)
{
    const std::string arguments = kTiny + "--set frames.limit=6 --overwrite --out faulty";
    const auto unfinished = [&]
    {
        std::size_t count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / "faulty"))
        {
            const std::string name = entry.path().filename().string();
            count += name.find(".part") != std::string::npos || name.ends_with(".tmp") ? 1 : 0;
        }
        return count;
    };
    for (const char* call : {"fsync", "rename"})
    {
        std::size_t left = 0; // some of the calls are those of folders, and leave none
        for (const int at : {2, 3, 4})
        {
            fs::create_directories(folder_ / "faulty");
            const Answer killed = runWith({call, "kill"}, at, arguments);
            EXPECT_EQ(killed.code, 128 + 9) << call;
            left += unfinished();
            EXPECT_EQ(run(arguments).code, 0) << call;
            EXPECT_EQ(unfinished(), 0u) << call;
        }
        EXPECT_GT(left, 0u) << call;
    }
}

TEST_F(FailingCalls, OfMemoryEndWith71OrNotAtAll)
{
    std::set<int> codes;
    for (int at = 1; at <= 2000; at += 1 + at / 3)
    {
        fs::remove_all(folder_ / "faulty");
        const Answer answer = runWith({"new", "12"}, at, kTiny + "--frames none --out faulty");
        codes.insert(answer.code);
        EXPECT_TRUE(answer.code == 71 || answer.code == 0)
            << at << ": " << answer.code << " " << answer.errors;
        EXPECT_EQ(answer.code == 0, fs::exists(folder_ / "faulty/summary.json")) << at;
    }
    EXPECT_EQ(codes.count(71), 1U) << "none has failed";
}

TEST_F(FailingCalls, OfMemoryEndWith71OrNotAtAllWhicheverOfTwoThousand) // with the label `long`
{
    int failed = 0;
    for (int at = 1; at <= 2000; ++at)
    {
        fs::remove_all(folder_ / "faulty");
        const Answer answer = runWith({"new", "12"}, at, kTiny + "--frames none --out faulty");
        ASSERT_TRUE(answer.code == 71 || answer.code == 0)
            << at << ": " << answer.code << " " << answer.errors;
        failed += answer.code == 71 ? 1 : 0;
    }
    EXPECT_GT(failed, 1000);
}

TEST_F(FailingCalls, OfAFullDiskAreToldWithWhatIsNeeded)
{
    fs::create_directory(folder_ / "small");
    const std::string mount =
        "mount -t tmpfs -o size=32k none '" + (folder_ / "small").string() + "'";
    if (std::system((mount + " 2>/dev/null").c_str()) != 0)
    {
        GTEST_SKIP() << "only root may mount a small file system";
    }
    const Answer answer =
        run("fill cube --count 20 --size 640x480 --set threads=1 --quiet --out small/run");
    const auto empty = [&]
    {
        std::size_t files = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / "small"))
        {
            files += entry.is_regular_file() && entry.file_size() == 0 ? 1 : 0;
        }
        return files;
    }();
    EXPECT_EQ(answer.code, 74) << answer.errors;
    EXPECT_NE(answer.errors.find("cannot write small/run/"), std::string::npos) << answer.errors;
    EXPECT_NE(answer.errors.find("bytes or more, and "), std::string::npos) << answer.errors;
    EXPECT_EQ(empty, 0u);
    EXPECT_EQ(std::system(("umount '" + (folder_ / "small").string() + "'").c_str()), 0);
}

TEST_F(FailingCalls, OfAFileThatMayNotGrowAreAFailedWrite)
{
    EXPECT_EQ(run("fill cube --count 200 --frames none --quiet --out faulty", "ulimit -f 8;").code,
              74);
    EXPECT_FALSE(fs::exists(folder_ / "faulty/summary.json"));
}

} // namespace
} // namespace frostfill

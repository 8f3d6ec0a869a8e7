// SPDX-License-Identifier: MIT
// One call of the program fails, then the next: each open, write, fsync, close and rename of a file
// of a run, and each allocation. Rows F3, F4 and F5 of docs/reliability.md.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;
namespace fs = std::filesystem;

// Three spheres and a few small pictures.
const std::string kTiny = "fill cube --radius 0.45 --count 3 --size 32x24 --threads 1 --quiet ";

/// Which call fails, and how; see fault_shim.c.
struct Failure
{
    std::string call;
    std::string how;
    bool stays = false;
};

class FailingCalls : public ::testing::Test
{
protected:
    void SetUp() override
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        GTEST_SKIP() << "a sanitizer has to be the first library that is loaded";
#endif
    }

    [[nodiscard]] Answer run(const std::string& arguments,
                             const std::string& environment = "") const
    {
        return test::runProgram(arguments, folder_.path(), environment);
    }

    /// Runs with the `at`-th call failing.
    [[nodiscard]] Answer runWith(const Failure& failure, int at, const std::string& arguments) const
    {
        fs::remove(folder_ / "mark");
        return run(arguments,
                   fmt::format("LD_PRELOAD='" FROSTFILL_FAULT_SHIM "' FAULT_CALL={} FAULT_HOW={} "
                               "FAULT_STAYS={} FAULT_AT={} FAULT_UNDER=faulty FAULT_MARK=mark",
                               failure.call, failure.how, failure.stays ? 1 : 0, at));
    }
    [[nodiscard]] bool hasFailed() const
    {
        return fs::exists(folder_ / "mark");
    }

    /// What every file of the run holds; of the summary only what is the same in every run.
    [[nodiscard]] std::map<std::string, std::string> contents(const std::string& directory) const
    {
        std::map<std::string, std::string> all;
        std::error_code none;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / directory, none))
        {
            const std::string name = fs::relative(entry.path(), folder_ / directory).string();
            if (!entry.is_regular_file())
            {
                continue;
            }
            all[name] = readFile(entry.path());
            if (name == "summary.json")
            {
                const auto summary = nlohmann::json::parse(all[name], nullptr, false);
                all[name] = summary.is_object() ? summary["state_hash"] : "not JSON";
            }
            if (name == "sets.csv") // times
            {
                all[name] = all[name].substr(0, all[name].find('\n'));
            }
        }
        return all;
    }

    /// Whatever stands under its final name is whole; a run that ends well has all.
    void expectNothingIsCorrupt(const Answer& answer,
                                const std::map<std::string, std::string>& whole,
                                const std::string& what) const
    {
        const auto found = contents("faulty");
        for (const auto& [name, content] : found)
        {
            const bool unfinished = name.ends_with(".tmp") || name.ends_with(".part");
            if (!unfinished)
            {
                ASSERT_TRUE(whole.contains(name)) << what << ": " << name;
                EXPECT_EQ(content == whole.at(name), true) << what << ": " << name;
            }
        }
        EXPECT_TRUE(answer.code == 0 || answer.code == 73 || answer.code == 74)
            << what << ": " << answer.code << " " << answer.errors;
        if (answer.code == 0)
        {
            EXPECT_EQ(found.size(), whole.size()) << what;
        }
        else
        {
            EXPECT_EQ(answer.errors.rfind("frostfill: ", 0), 0u) << what << answer.errors;
        }
    }

    /// The calls, or all of them if `every`, some way apart: the first ones next to each other.
    [[nodiscard]] static int next(int at, bool every)
    {
        return every ? at + 1 : at + 1 + at / 2;
    }

    void expectEachIsBorne(const std::vector<Failure>& failures, bool every = false) const
    {
        const std::string arguments = kTiny + "--frames 0:3 --out "; // nothing is thinned out
        ASSERT_EQ(run(arguments + "whole").code, 0);
        const auto whole = contents("whole");
        ASSERT_GT(whole.size(), 6u);
        for (const Failure& failure : failures)
        {
            int at = 1;
            for (bool failed = true; failed; at = next(at, every))
            {
                fs::remove_all(folder_ / "faulty");
                const Answer answer = runWith(failure, at, arguments + "faulty");
                failed = hasFailed();
                const std::string what = fmt::format("{} {} {}", failure.call, at, failure.how);
                expectNothingIsCorrupt(answer, whole, what);
                const bool invisible = failure.how == "4" || failure.how == "short";
                if (invisible || !failed)
                {
                    EXPECT_EQ(answer.code, 0) << what << ": " << answer.errors;
                }
                ASSERT_LT(at, 200) << what;
            }
            EXPECT_GT(at, 3) << failure.call << " was never called";
        }
    }

    test::TemporaryFolder folder_;
};

// ENOSPC 28, EIO 5, EACCES 13, EINTR 4.
TEST_F(FailingCalls, LeaveNoCorruptFileAndNoFalseSuccess)
{
    expectEachIsBorne(
        {{"open", "28"}, {"write", "28"}, {"fsync", "5"}, {"close", "5"}, {"rename", "13"}});
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

/// The number that a picture has been given in the run, before any thinning.
int frameOf(const std::string& png)
{
    const std::string key = std::string("tEXtFrame") + '\0';
    const std::size_t found = png.find(key);
    if (found == std::string::npos)
    {
        return -1;
    }
    // The length of a chunk, of which the last byte is enough here, stands before its name.
    const auto length = static_cast<unsigned char>(png[found - 1]);
    return std::stoi(png.substr(found + key.size(), length - std::string("Frame").size() - 1));
}

/// The pictures of a run stand without a gap, and are equally far from one another, but for the
/// last, which shows how the run ended.
void expectNoGap(const fs::path& folder, const std::string& what)
{
    std::vector<int> frames;
    const auto file = [&] { return folder / fmt::format("frame_{:05}.png", frames.size()); };
    while (fs::exists(file()))
    {
        frames.push_back(frameOf(readFile(file())));
    }
    std::size_t pictures = 0;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
    {
        pictures += entry.path().extension() == ".png" ? 1 : 0;
    }
    EXPECT_EQ(frames.size(), pictures) << what;
    for (std::size_t k = 2; k + 1 < frames.size(); ++k)
    {
        EXPECT_EQ(frames[k] - frames[k - 1], frames[1] - frames[0]) << what;
    }
}

TEST_F(FailingCalls, AKillWhilePicturesAreThinnedOutLeavesNoGap)
{
    const std::string arguments = kTiny + "--max-frames 6 --overwrite --out faulty";
    for (const char* call : {"link", "renameat2", "unlink", "rename"})
    {
        int kills = 0;
        for (int at = 1;; at = next(at, false))
        {
            fs::remove_all(folder_ / "faulty");
            const Answer answer = runWith({call, "kill"}, at, arguments);
            if (!hasFailed())
            {
                EXPECT_EQ(answer.code, 0) << answer.errors;
                break;
            }
            ++kills;
            EXPECT_EQ(answer.code, 128 + 9) << call << at << answer.errors;
            expectNoGap(folder_ / "faulty/frames", fmt::format("{} {}", call, at));
            ASSERT_LT(at, 300);
        }
        EXPECT_GT(kills, 2) << call;
    }
}

TEST_F(FailingCalls, WhatAKillLeavesTheNextRunClearsAway)
{
    const std::string arguments = kTiny + "--max-frames 6 --overwrite --out faulty";
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
    for (const char* call : {"link", "fsync", "rename"})
    {
        EXPECT_EQ(runWith({call, "kill"}, 3, arguments).code, 128 + 9) << call;
        EXPECT_GT(unfinished(), 0u) << call;
        EXPECT_EQ(run(arguments).code, 0) << call;
        EXPECT_EQ(unfinished(), 0u) << call;
    }
}

// File systems without hard links, or on which folders cannot change places in one step.
TEST_F(FailingCalls, ThatThinningCanDoWithoutChangeNoPicture)
{
    const std::string arguments = kTiny + "--max-frames 6 --out ";
    ASSERT_EQ(run(arguments + "whole").code, 0);
    for (const char* call : {"link", "renameat2"})
    {
        fs::remove_all(folder_ / "faulty");
        const Answer answer = runWith({call, "1", true}, 1, arguments + "faulty");
        EXPECT_TRUE(hasFailed()) << call;
        EXPECT_EQ(answer.code, 0) << call << answer.errors;
        EXPECT_TRUE(contents("faulty") == contents("whole")) << call;
    }
}

TEST_F(FailingCalls, OfMemoryEndWith71OrNotAtAll)
{
    for (int at = 1; at <= 2000; at += 1 + at / 3)
    {
        fs::remove_all(folder_ / "faulty");
        const Answer answer = runWith({"new", "12"}, at, kTiny + "--frames none --out faulty");
        EXPECT_TRUE(answer.code == 71 || answer.code == 0)
            << at << ": " << answer.code << " " << answer.errors;
        EXPECT_EQ(answer.code == 0, fs::exists(folder_ / "faulty/summary.json")) << at;
    }
}

TEST_F(FailingCalls, OfMemoryEndWith71OrNotAtAllWhicheverOfTwoThousand) // with the label `long`
{
    for (int at = 1; at <= 2000; ++at)
    {
        fs::remove_all(folder_ / "faulty");
        const Answer answer = runWith({"new", "12"}, at, kTiny + "--frames none --out faulty");
        ASSERT_TRUE(answer.code == 71 || answer.code == 0)
            << at << ": " << answer.code << " " << answer.errors;
    }
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
        run("fill cube --count 20 --size 640x480 --threads 1 --quiet --out small/run");
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

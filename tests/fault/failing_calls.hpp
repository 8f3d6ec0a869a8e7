// SPDX-License-Identifier: MIT
#pragma once

#include "base/resources.hpp"
#include "fault/program.hpp"
#include "fault/run_file_bytes.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace frostfill::test
{

// Three spheres and a few small pictures.
inline const std::string kTiny =
    "fill cube --radius 0.45 --count 3 --size 32x24 --set threads=1 --quiet ";

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
#ifdef FROSTFILL_SANITIZED
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
        std::filesystem::remove(folder_ / "mark");
        return test::runProgram(
            arguments, folder_.path(),
            fmt::format("LD_PRELOAD='" FROSTFILL_FAULT_SHIM "' FAULT_CALL={} FAULT_HOW={} "
                        "FAULT_STAYS={} FAULT_AT={} FAULT_UNDER=faulty FAULT_MARK=mark",
                        failure.call, failure.how, failure.stays ? 1 : 0, at));
    }
    [[nodiscard]] bool hasFailed() const
    {
        return std::filesystem::exists(folder_ / "mark");
    }

    /// What every file of the run holds; of the summary only what is the same in every run.
    [[nodiscard]] std::map<std::string, std::string> contents(const std::string& directory) const
    {
        std::map<std::string, std::string> all;
        std::error_code none;
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(folder_ / directory, none))
        {
            const std::string name =
                std::filesystem::relative(entry.path(), folder_ / directory).string();
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
            if (name == "run.frost") // which ends with the summary
            {
                all[name] = withoutSummary(all[name]);
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
            // A run that could not keep its states leaves what it can begin again by.
            const bool unfinished = name.ends_with(".tmp") || name.ends_with(".part") ||
                                    (name == "begun.frost" && answer.code != 0);
            if (name == "run.frost" && answer.code != 0)
            {
                // Appended as the run goes: what is there is the beginning of all.
                EXPECT_TRUE(whole.at(name).starts_with(content)) << what << ": " << name;
            }
            else if (!unfinished)
            {
                ASSERT_TRUE(whole.contains(name)) << what << ": " << name;
                const auto [here, there] = std::mismatch(
                    content.begin(), content.end(), whole.at(name).begin(), whole.at(name).end());
                EXPECT_TRUE(content == whole.at(name))
                    << what << ": " << name << " has " << content.size() << " bytes instead of "
                    << whole.at(name).size() << " and differs from byte " << here - content.begin()
                    << " on; exit code " << answer.code << ", a call has failed: " << hasFailed();
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
        std::filesystem::remove_all(folder_ / "whole");              // of the failures before
        ASSERT_EQ(run(arguments + "whole").code, 0);
        const auto whole = contents("whole");
        ASSERT_GT(whole.size(), 6u);
        for (const Failure& failure : failures)
        {
            int at = 1;
            for (bool failed = true; failed; at = next(at, every))
            {
                std::filesystem::remove_all(folder_ / "faulty");
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

} // namespace frostfill::test

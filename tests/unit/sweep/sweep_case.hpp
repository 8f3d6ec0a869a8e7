// SPDX-License-Identifier: MIT
#pragma once

#include "support/temporary_folder.hpp"

#include <frostfill/sweep.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace frostfill::test
{

inline constexpr const char* kSweep = R"(
[scene]
frames.which = "none"
threads = 1
spheres.radius = 0.4
[sweep]
object.mesh = ["cube", "sphere"]
seed = [1, 2, 3]
)";

/// Six runs without pictures.
class SweepCase : public ::testing::Test
{
protected:
    [[nodiscard]] SweepRequest request(const std::string& toml = kSweep) const
    {
        SweepRequest sweep;
        sweep.runs = parseSweep(toml, "sweep.toml");
        sweep.directory = folder_ / "out";
        return sweep;
    }
    [[nodiscard]] std::filesystem::path folderOf(const SweepRun& run) const
    {
        return folder_ / "out" / run.name;
    }
    /// What is in every folder of a run, without what tells the time.
    [[nodiscard]] std::map<std::string, std::string> results(const SweepRequest& sweep) const
    {
        std::map<std::string, std::string> all;
        for (const SweepRun& run : sweep.runs)
        {
            all[run.name] = readFile(folderOf(run) / "spheres.csv");
        }
        return all;
    }
    TemporaryFolder folder_;
};

inline std::vector<RunStatus> statusesOf(const std::vector<RunReport>& reports)
{
    std::vector<RunStatus> statuses;
    for (const RunReport& report : reports)
    {
        statuses.push_back(report.status);
    }
    return statuses;
}

/// The indices of the runs that are not skipped.
inline std::vector<std::size_t> doneAnew(const SweepRequest& sweep)
{
    std::vector<std::size_t> anew;
    SweepObserver observer;
    observer.ended = [&](std::size_t index, const RunReport&, bool skipped)
    {
        if (!skipped)
        {
            anew.push_back(index);
        }
    };
    (void)runSweep(sweep, observer);
    return anew;
}

} // namespace frostfill::test

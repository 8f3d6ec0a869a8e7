// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/fill.hpp>
#include <frostfill/shard.hpp>
#include <frostfill/sweep_file.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

enum class RunStatus : std::uint8_t
{
    done,    ///< its files are there and say that they are of this very run
    failed,  ///< with an exit code and a sentence
    stopped, ///< by a signal; or its process was killed
    running, ///< in some process, here or on another machine
    missing, ///< never begun; or there is another run in its place
};

inline constexpr std::array kRunStatuses = {RunStatus::done, RunStatus::failed, RunStatus::stopped,
                                            RunStatus::running, RunStatus::missing};

/// "done", "failed", "stopped", "running" or "missing".
[[nodiscard]] const char* statusName(RunStatus status);

/// What is known of a run.
struct RunReport
{
    RunStatus status = RunStatus::missing;
    int exitCode = 0;    ///< see ErrorCode; of a process that a signal has ended, 128 + the signal
    std::string message; ///< what went wrong, in a sentence; empty when done
};

/// Does what a request asks for, and says how it ended. Throws nothing.
using RunOnce = std::function<RunReport(const FillRequest&, const FillObserver&)>;

/// In this process.
[[nodiscard]] RunReport runHere(const FillRequest& request, const FillObserver& observer);

/// In a process of its own, so that a run that crashes or takes too much memory ends nothing but
/// itself. It is asked to stop with SIGTERM, and ends with this process. The caller must have no
/// other threads. `observer` is called in that process, but for stopRequested in both.
[[nodiscard]] RunReport runApart(const FillRequest& request, const FillObserver& observer);

struct SweepRequest
{
    std::vector<SweepRun> runs;      ///< all of them; see loadSweep
    std::filesystem::path directory; ///< each run has a folder of its name in it
    Shard shard;                     ///< which runs this process does
    bool overwrite = false;          ///< replace other runs that have the place of one of these
    RunOnce runOnce = &runHere;
};

/// What the caller wants to hear. Every function may be empty.
struct SweepObserver
{
    /// Run `index` of all begins; `done` of the `all` runs of this shard are over.
    std::function<void(std::size_t index, std::size_t done, std::size_t all)> begins;
    std::function<void(const FillProgress&)> progressed; ///< of the run that has begun; see RunOnce
    /// Run `index` is over, or was so before. `skipped`: it was done already.
    std::function<void(std::size_t index, const RunReport&, bool skipped)> ended;
    std::function<bool()> stopRequested;
};

/// The indices of the runs of the shard, in order.
[[nodiscard]] std::vector<std::size_t> runsOf(const SweepRequest& request);

/// Does the runs of a shard one after the other: skips those that are done, resumes those that
/// were interrupted, repeats those that failed, and leaves alone what another process is doing. A
/// run that fails stops no other. Returns a report for each run of the shard, in order. Throws
/// Error cannotCreate when the directory cannot be made.
std::vector<RunReport> runSweep(const SweepRequest& request, const SweepObserver& observer = {});

/// Reports on all runs, whatever the shard, from what lies in their folders. Writes nothing.
[[nodiscard]] std::vector<RunReport> inspectSweep(const SweepRequest& request);

/// Writes table.csv and table.json into the directory: a row for each run with its status, what was
/// swept, and all numbers and words of its summary.json but the scene and the machine. Throws Error
/// cannotCreate or writeFailed.
void writeSweepTable(const SweepRequest& request, const std::vector<RunReport>& reports);

} // namespace frostfill
#pragma GCC visibility pop

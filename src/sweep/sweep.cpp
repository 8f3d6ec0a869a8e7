// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "sweep/claim.hpp"
#include "sweep/run_record.hpp"
#include "sweep/run_status.hpp"

#include <frostfill/sweep.hpp>

#include <fmt/format.h>

#include <chrono>

namespace frostfill
{
namespace
{

/// The request for a run, with what its folder holds. Throws Error cannotCreate for another run.
FillRequest fillRequest(const SweepRequest& sweep, const SweepRun& run, const std::string& runHash)
{
    FillRequest request;
    request.scene = run.scene;
    request.directory = sweep.directory / run.name;
    const FolderContent content = contentOf(run.scene, runHash, request.directory);
    if (content == FolderContent::other && !sweep.overwrite)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("{} holds another run; give --overwrite to replace it, or another "
                                "directory with --out",
                                request.directory.string()));
    }
    request.resume = content == FolderContent::resumable;
    request.overwrite = !request.resume;
    return request;
}

/// Does a run that this process holds. Throws Error when it cannot begin or cannot be noted.
RunReport doRun(const SweepRequest& sweep, const SweepRun& run, const std::string& runHash,
                const SweepObserver& observer)
{
    const std::filesystem::path folder = sweep.directory / run.name;
    const auto start = std::chrono::steady_clock::now();
    const FillRequest request = fillRequest(sweep, run, runHash);
    RunNote note;
    note.runHash = runHash;
    note.report.status = RunStatus::running;
    writeNote(folder, note);
    FillObserver fillObserver;
    fillObserver.progressed = observer.progressed;
    fillObserver.stopRequested = observer.stopRequested;
    note.report = sweep.runOnce(request, fillObserver);
    note.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    writeNote(folder, note);
    return note.report;
}

/// A mesh that cannot be used fails every run that is filled with it.
RunReport failedBefore(const std::filesystem::path& folder, const Error& error)
{
    RunReport report = failed(error);
    try
    {
        const Claim claim(folder);
        if (claim.holds())
        {
            RunNote note;
            note.report = report;
            writeNote(folder, note);
        }
    }
    catch (const Error&)
    {
        // The report says what is wrong, whether it can be noted or not.
    }
    return report;
}

RunReport claimAndDo(const SweepRequest& sweep, const SweepRun& run, const std::string& runHash,
                     const SweepObserver& observer, const std::function<void()>& begins,
                     bool& skipped)
{
    const std::filesystem::path folder = sweep.directory / run.name;
    try
    {
        const Claim claim(folder); // first: what is looked at must not change any more
        if (!claim.holds())
        {
            return {RunStatus::running, 0,
                    fmt::format("another process writes to {}", folder.string())};
        }
        skipped = isComplete(run.scene, runHash, folder);
        if (skipped)
        {
            return {RunStatus::done, 0, ""};
        }
        begins();
        return doRun(sweep, run, runHash, observer);
    }
    catch (const Error& error)
    {
        return failed(error);
    }
}

} // namespace

std::vector<std::size_t> runsOf(const SweepRequest& request)
{
    std::vector<std::size_t> ours;
    for (std::size_t k = 0; k < request.runs.size(); ++k)
    {
        if (request.shard.owns(k))
        {
            ours.push_back(k);
        }
    }
    return ours;
}

std::vector<RunReport> runSweep(const SweepRequest& request, const SweepObserver& observer)
{
    createDirectory(request.directory);
    const std::vector<std::size_t> ours = runsOf(request);
    RunHashes hashes;
    std::vector<RunReport> reports;
    for (const std::size_t k : ours)
    {
        const SweepRun& run = request.runs[k];
        bool skipped = false;
        RunReport report = {RunStatus::stopped, static_cast<int>(ErrorCode::stoppedEarly),
                            "not begun: the sweep was stopped"};
        if (!observer.stopRequested || !observer.stopRequested())
        {
            const auto begins = [&]
            {
                if (observer.begins)
                {
                    observer.begins(k, reports.size(), ours.size());
                }
            };
            try
            {
                report = claimAndDo(request, run, hashes.of(run.scene), observer, begins, skipped);
            }
            catch (const Error& error)
            {
                report = failedBefore(request.directory / run.name, error);
            }
        }
        reports.push_back(report);
        if (observer.ended)
        {
            observer.ended(k, report, skipped);
        }
    }
    return reports;
}

std::vector<RunReport> inspectSweep(const SweepRequest& request)
{
    RunHashes hashes;
    std::vector<RunReport> reports;
    for (const SweepRun& run : request.runs)
    {
        try
        {
            reports.push_back(
                lookAt(run.scene, hashes.of(run.scene), request.directory / run.name));
        }
        catch (const Error& error)
        {
            reports.push_back(failed(error));
        }
    }
    return reports;
}

} // namespace frostfill

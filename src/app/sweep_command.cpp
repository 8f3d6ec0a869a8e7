// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/scene_options.hpp"

#include <frostfill/plan_fill.hpp>
#include <frostfill/sweep.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kSweepExamples = R"(Examples:
  frostfill sweep sweep.toml                    every run that is not done, in output/sweep
  frostfill sweep sweep.toml --dry-run          what would be done
  frostfill sweep sweep.toml --shard 3/16       the third of sixteen parts
  frostfill sweep sweep.toml --shard slurm      the part of this task of a Slurm job array
  frostfill sweep sweep.toml --gather           one table, when all parts are done
)";

struct SweepArguments
{
    std::string file;
    std::string directory;
    std::string shard;
    bool gather = false;
    bool allowIncomplete = false;
    bool overwrite = false;
    bool dryRun = false;
    bool quiet = false;
    GivenOptions given;
};

/// Changes the settings of all runs. Throws Error usage for one of which the sweep has a list.
void applyToAll(const GivenOptions& given, std::vector<SweepRun>& runs)
{
    for (SweepRun& run : runs)
    {
        for (const auto& [key, text] : run.swept)
        {
            if (given.contains(&optionOf(key)))
            {
                throw Error(ErrorCode::usage,
                            fmt::format("{} has a list of values in the sweep: omit --set", key));
            }
        }
        applyGivenOptions(given, run.scene);
        (void)impliesJointRest(given, run.scene);
    }
}

SweepRequest requestOf(const SweepArguments& arguments)
{
    SweepRequest request;
    request.runs = loadSweep(arguments.file);
    applyToAll(arguments.given, request.runs);
    request.directory =
        arguments.directory.empty()
            ? std::filesystem::path("output") / std::filesystem::path(arguments.file).stem()
            : std::filesystem::path(arguments.directory);
    request.shard = arguments.shard.empty() ? Shard{} : parseShard(arguments.shard);
    request.overwrite = arguments.overwrite;
    request.runOnce = &runApart;
    return request;
}

/// "failed with 65: 'part.stl' cannot be filled: ...".
std::string reportText(const RunReport& report)
{
    std::string text = statusName(report.status);
    if (report.exitCode != 0)
    {
        text += fmt::format(" with {}", report.exitCode);
    }
    return report.message.empty() ? text : fmt::format("{}: {}", text, report.message);
}

std::size_t countOf(RunStatus status, const std::vector<RunReport>& reports)
{
    return static_cast<std::size_t>(std::count_if(reports.begin(), reports.end(),
                                                  [&](const RunReport& report)
                                                  { return report.status == status; }));
}

/// "20 done, 1 failed"; those that there are none of are not mentioned.
std::string countsText(const std::vector<RunReport>& reports)
{
    std::string text;
    for (const RunStatus status : kRunStatuses)
    {
        if (const std::size_t count = countOf(status, reports); count > 0)
        {
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, statusName(status));
        }
    }
    return text.empty() ? "no runs" : text;
}

int exitCodeOf(const std::vector<RunReport>& reports)
{
    if (countOf(RunStatus::failed, reports) > 0)
    {
        return static_cast<int>(ErrorCode::thresholdFailed);
    }
    return countOf(RunStatus::done, reports) == reports.size()
               ? 0
               : static_cast<int>(ErrorCode::stoppedEarly);
}

int gather(const SweepArguments& arguments, const SweepRequest& request)
{
    const std::vector<RunReport> reports = inspectSweep(request);
    if (countOf(RunStatus::done, reports) < reports.size() && !arguments.allowIncomplete)
    {
        for (std::size_t k = 0; k < reports.size(); ++k)
        {
            if (reports[k].status != RunStatus::done)
            {
                say(fmt::format("{}: {}\n", request.runs[k].name, reportText(reports[k])));
            }
        }
        throw Error(ErrorCode::badData,
                    fmt::format("the sweep in {} is not complete: {} of {} runs; run it again for "
                                "the rest, or gather with --allow-incomplete",
                                request.directory.string(), countsText(reports), reports.size()));
    }
    writeSweepTable(request, reports);
    if (!arguments.quiet)
    {
        fmt::print("{}; table in {}\n", countsText(reports),
                   (request.directory / "table.csv").string());
    }
    return exitCodeOf(reports);
}

struct DryReport
{
    std::string text;
    bool fails = false;
};

/// What fill would do with a run, without pictures, so that there is no trial run.
DryReport dryReport(const SweepRequest& sweep, const SweepRun& run, const RunReport& report)
{
    if (report.status == RunStatus::done || report.status == RunStatus::running)
    {
        return {fmt::format("skipped, as it is {}", statusName(report.status))};
    }
    FillRequest request;
    request.scene = run.scene;
    request.scene.frames.enabled = false;
    request.scene.frames.keepRun = false;
    request.directory = sweep.directory / run.name;
    request.overwrite = true;
    try
    {
        const FillPlan plan = planFill(request);
        return {fmt::format("about {} spheres of {:.4g}{}", plan.spheres, plan.largestRadius,
                            report.status == RunStatus::missing && report.message.empty()
                                ? ""
                                : fmt::format("; now {}", reportText(report)))};
    }
    catch (const Error& error)
    {
        return {fmt::format("would fail with {}: {}", static_cast<int>(error.code()), error.what()),
                true};
    }
}

int printDryRun(const SweepRequest& request)
{
    const std::vector<RunReport> reports = inspectSweep(request);
    bool fails = false;
    for (const std::size_t k : runsOf(request))
    {
        const DryReport report = dryReport(request, request.runs[k], reports[k]);
        fails = fails || report.fails;
        fmt::print("{}: {}\n", request.runs[k].name, report.text);
    }
    fmt::print("{} runs of {}; nothing was written\n", runsOf(request).size(), request.runs.size());
    return fails ? static_cast<int>(ErrorCode::thresholdFailed) : 0;
}

/// Shows how far the runs of a shard are.
class SweepProgress
{
public:
    SweepProgress(const SweepArguments& arguments, const SweepRequest& request)
        : arguments_(arguments), request_(request), all_(runsOf(request).size()),
          bar_(!arguments.quiet && isatty(STDERR_FILENO) == 1)
    {
    }

    void begins(std::size_t index) { index_ = index; }
    void progressed(const FillProgress& progress)
    {
        const std::string& name = request_.runs[index_].name;
        if (bar_)
        {
            const double share = static_cast<double>(progress.spheres) /
                                 static_cast<double>(std::max<std::size_t>(1, progress.expected));
            line_.update((static_cast<double>(done_) + std::min(1.0, share)) /
                             static_cast<double>(all_),
                         fmt::format("{}/{} runs", done_, all_), name);
        }
    }
    void ended(std::size_t index, const RunReport& report, bool skipped)
    {
        ++done_;
        line_.close();
        if (!arguments_.quiet)
        {
            fmt::print("{}/{} {}: {}\n", done_, all_, request_.runs[index].name,
                       skipped ? "was done already" : reportText(report));
            std::fflush(stdout); // a job that is killed leaves what it has said
        }
    }

private:
    const SweepArguments& arguments_;
    const SweepRequest& request_;
    std::size_t all_;
    bool bar_;
    std::size_t done_ = 0;
    std::size_t index_ = 0;
    TaskBar line_;
};

int sweep(const SweepArguments& arguments)
{
    const SweepRequest request = requestOf(arguments);
    if (arguments.gather)
    {
        return gather(arguments, request);
    }
    if (arguments.dryRun)
    {
        return printDryRun(request);
    }
    catchStopSignals();
    runHasBegun();
    SweepProgress progress(arguments, request);
    SweepObserver observer;
    observer.begins = [&](std::size_t index, std::size_t, std::size_t) { progress.begins(index); };
    observer.progressed = [&](const FillProgress& now) { progress.progressed(now); };
    observer.ended = [&](std::size_t index, const RunReport& report, bool skipped)
    { progress.ended(index, report, skipped); };
    observer.stopRequested = &stopRequested;
    const std::vector<RunReport> reports = runSweep(request, observer);
    if (request.shard.count == 1)
    {
        writeSweepTable(request, reports);
    }
    if (!arguments.quiet)
    {
        fmt::print("{}; results in {}\n", countsText(reports), request.directory.string());
    }
    return exitCodeOf(reports);
}

} // namespace

Command addSweepCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<SweepArguments>();
    CLI::App* command = program.add_subcommand(
        "sweep", "Fill once for each combination of values; on one machine or many");
    command->footer(kSweepExamples);
    command->add_option("FILE", arguments->file, "Scene file with lists of values (TOML)")
        ->required();
    command
        ->add_option("--out", arguments->directory,
                     "Directory of the runs, a folder for each (output/FILE)")
        ->type_name("DIR");
    command
        ->add_option("--shard", arguments->shard,
                     "Do only the I-th of N parts; slurm: that of this task of a job array")
        ->type_name("I/N|slurm");
    CLI::Option* gather = command->add_flag(
        "--gather", arguments->gather, "Run nothing; write one table of all runs if all are done");
    command
        ->add_flag("--allow-incomplete", arguments->allowIncomplete,
                   "Gather the runs that exist, with the status of each run")
        ->needs(gather);
    command->add_flag("--overwrite", arguments->overwrite,
                      "Replace other runs in the folders of these");
    command->add_flag("--dry-run", arguments->dryRun,
                      "Check everything and say what would be done, but write nothing");
    command->add_flag("--quiet", arguments->quiet, "Print errors only");
    addSceneOptions(*command, arguments->given);
    return [arguments] { return sweep(*arguments); };
}

} // namespace frostfill

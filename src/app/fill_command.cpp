// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/fill_request.hpp"
#include "app/fill_text.hpp"
#include "app/out_file.hpp"
#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/view_text.hpp"
#include "run/run_directory.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/options.hpp>
#include <frostfill/plan_fill.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

namespace frostfill
{
namespace
{

constexpr const char* kFillExamples = R"(Examples:
  frostfill fill torus                           the paper's run, with frames
  frostfill fill part.stl --up z --units mm --count 500
  frostfill fill bust.stl --lid --radius 0.02    close an opening, fill until full
  frostfill fill cube --out cube.mp4             a video
  frostfill fill output/torus/summary.json --seed 2 --out output/again
  frostfill fill --resume output/torus           go on after a kill or a stop)";

/// The page of a run that has just been written. Returns what went wrong, which matters less than
/// what went wrong with the run.
std::optional<Error> writePageOf(const FillTask& task, const FillArguments& arguments)
{
    if (task.page.empty())
    {
        return std::nullopt;
    }
    PageRequest page;
    page.run = task.request.directory;
    page.file = task.page;
    page.overwrite = arguments.overwrite;
    try
    {
        writePageWithProgress(page, arguments.quiet || arguments.json);
    }
    catch (const Error& error)
    {
        return error;
    }
    return std::nullopt;
}

/// Whether a run that is to be resumed has come to its end before, and no other pictures are asked
/// for. Throws Error if it is not the one that is requested.
bool hasEnded(const FillRequest& request, const FillArguments& arguments,
              const std::string& outcome)
{
    const bool draws =
        !arguments.video.empty() || arguments.given.contains(&optionOf("camera.path"));
    return request.resume && !draws && !outcome.empty() && outcome != "stopped" &&
           meshOfEarlierRun(request).has_value();
}

/// Says what the run would be, and where it would be written.
int printDryRun(const FillRequest& request)
{
    printPlan(request, planFill(request));
    fmt::print("nothing was written; the run would {} {}\n",
               request.resume      ? "go on in"
               : request.overwrite ? "replace what is in"
                                   : "be written to",
               request.directory.string());
    return 0;
}

FillObserver observerOf(const FillArguments& arguments, const FillRequest& request,
                        ProgressBar& bar)
{
    FillObserver observer;
    observer.loaded = &runHasBegun;
    observer.stopRequested = &stopRequested;
    if (!arguments.quiet)
    {
        observer.planned = [&](const FillPlan& plan)
        {
            bar.close(); // of a run that was simulated before
            printPlan(request, plan);
        };
        observer.progressed = [&](const FillProgress& progress) { bar.update(progress); };
    }
    return observer;
}

/// The exit code of a run that has ended. Throws what failed.
int outcomeOf(const FillResult& result, const std::optional<Error>& pageFailure)
{
    if (const auto failure = failureOf(result))
    {
        throw *failure;
    }
    if (pageFailure)
    {
        throw *pageFailure;
    }
    return result.stopped ? static_cast<int>(ErrorCode::stoppedEarly) : 0;
}

int runFill(const FillArguments& arguments)
{
    const FillTask task = taskOf(arguments);
    const FillRequest& request = task.request;
    const std::string outcome = request.resume ? outcomeOfRun(request.directory) : "";
    if (hasEnded(request, arguments, outcome))
    {
        say(fmt::format("the run in {} has ended ({}): nothing to resume\n",
                        request.directory.string(), outcome));
        return outcome == "failed" ? static_cast<int>(ErrorCode::postcondition) : 0;
    }
    if (arguments.dryRun)
    {
        return printDryRun(request);
    }

    ProgressBar bar;
    const FillObserver observer = observerOf(arguments, request, bar);
    catchStopSignals();
    const FillResult result = fill(request, observer);
    bar.close();
    if (arguments.json)
    {
        fmt::print("{}", result.summary);
    }
    else if (!arguments.quiet)
    {
        printResult(request.scene, result);
    }
    if (!task.picture.empty() && result.frames > 0)
    {
        copyPicture(request.directory, task.picture);
    }
    return outcomeOf(result, result.stopped ? std::nullopt : writePageOf(task, arguments));
}

} // namespace

Command addFillCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<FillArguments>();
    CLI::App* command = program.add_subcommand(
        "fill", "Fill a mesh with spheres; write frames, tables and a summary");
    command->footer(kFillExamples);
    addMeshArgument(*command, "MESH", arguments->mesh,
                    "torus, sphere, cube, human, a container such as cylinder:1,4, a mesh file, "
                    "several files or a folder with its patches, or a scene: FILE.toml or the "
                    "summary.json of a run");
    addSceneOptions(*command, arguments->given);
    const auto add = [&](const char* name, auto& value, const char* help, const char* type)
    { command->add_option(name, value, help)->type_name(type)->group("Output"); };
    const auto addFlag = [&](const char* name, bool& value, const char* help)
    { command->add_flag(name, value, help)->group("Output"); };
    add("--out", arguments->out, "Folder of the run, or a file: .mp4, .webm, .gif, .png, .html",
        "DIR|FILE");
    add("--video", arguments->video,
        "Also make a video: .mp4, .webm, .gif, or - for standard output", "FILE");
    add("--resume", arguments->resume, "Continue the run in this folder, to the same results",
        "DIR");
    addFlag("--overwrite", arguments->overwrite, "Replace an earlier run");
    addFlag("--dry-run", arguments->dryRun, "Check all and say what would be done; write nothing");
    addFlag("--quiet", arguments->quiet, "Print errors only");
    addFlag("--json", arguments->json, "Print the summary as JSON on standard output");
    return [arguments] { return runFill(*arguments); };
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/progress/json_progress.hpp"
#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/scene_options.hpp"

#include <frostfill/error.hpp>
#include <frostfill/render_run.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kRenderExamples = R"(Examples:
  frostfill render output/torus                            the same pictures, in output/torus/render
  frostfill render output/torus --frames last --size 3840x2160 --style studio --out poster
  frostfill render output/torus --frames 100..200 --turntable 8 --video turn.mp4
  frostfill render output/torus --skip-existing            go on after a kill
  frostfill render output/torus --shard 3/16               the third of sixteen parts of the pictures
  frostfill render output/torus --gather                   whether all pictures are there
)";

struct RenderArguments
{
    RenderRequest request;
    std::string run;
    std::string directory;
    std::string video;
    std::string shard;
    JsonProgress progress;
    bool quiet = false;
    bool json = false;
    GivenOptions given;
};

void printResult(const RenderArguments& arguments, const RenderResult& result)
{
    if (result.wholeBytes < result.fileBytes)
    {
        say(fmt::format("{} is incomplete: {} of its {} bytes can be read, with {} frames; the "
                        "rest is left out\n",
                        arguments.run, result.wholeBytes, result.fileBytes, result.keptFrames));
    }
    else if (!result.ended)
    {
        say(fmt::format("the run in {} has not ended: there are {} frames so far\n", arguments.run,
                        result.keptFrames));
    }
    if (arguments.request.dryRun)
    {
        fmt::print("nothing was written; {} pictures would be drawn into {}\n", result.frames,
                   result.directory.string());
        return;
    }
    if (arguments.request.gather)
    {
        fmt::print("all {} pictures are in {}\n", result.allFrames, result.directory.string());
        return;
    }
    fmt::print("{}{} pictures{}; {:.1f} s; results in {}\n", result.frames,
               result.frames < result.allFrames ? fmt::format(" of {}", result.allFrames) : "",
               result.skippedFrames > 0
                   ? fmt::format(", of which {} were there already", result.skippedFrames)
                   : "",
               result.wallSeconds, result.directory.string());
}

/// Throws Error badData unless all pictures are there, and no others.
void requireAll(const RenderResult& result)
{
    constexpr std::size_t kMaxNamed = 10;
    if (!result.missing.empty())
    {
        const std::vector<std::size_t> named(
            result.missing.begin(),
            result.missing.begin() +
                static_cast<std::ptrdiff_t>(std::min(kMaxNamed, result.missing.size())));
        throw Error(ErrorCode::badData,
                    fmt::format("{} of the {} pictures in {} are missing or wrong: {}{}; draw them "
                                "with the same options and --skip-existing",
                                result.missing.size(), result.allFrames, result.directory.string(),
                                fmt::join(named, ", "),
                                named.size() < result.missing.size() ? ", ..." : ""));
    }
    if (result.surplus > 0)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{} holds {} pictures of another rendering beside these {}; remove "
                                "them, or draw into another directory",
                                result.directory.string(), result.surplus, result.allFrames));
    }
}

int runRender(RenderArguments& arguments)
{
    RenderRequest request = arguments.request;
    request.run = arguments.run;
    request.directory = arguments.directory;
    request.video = arguments.video;
    request.shard = arguments.shard.empty() ? Shard{} : parseShard(arguments.shard);
    if (request.overwrite && request.skipExisting)
    {
        throw Error(ErrorCode::usage, "--overwrite removes what --skip-existing would skip: omit "
                                      "one of them");
    }
    request.change = [&](Scene& scene)
    {
        applyGivenOptions(arguments.given, scene);
        if (!scene.frames.enabled)
        {
            throw Error(ErrorCode::usage, "--frames none leaves nothing to draw");
        }
        runHasBegun();
    };
    TaskBar bar;
    RenderObserver observer;
    observer.stopRequested = &stopRequested;
    if (!arguments.quiet)
    {
        observer.progressed = [&](std::size_t done, std::size_t all)
        { bar.update(done, all, "frames"); };
    }
    if (arguments.progress.wanted())
    {
        observer.progressed = [&](std::size_t done, std::size_t all)
        { arguments.progress.show("drawing", done, all, "frames"); };
    }
    catchStopSignals();
    const RenderResult result = renderRun(request, observer);
    bar.close();

    if (request.gather)
    {
        requireAll(result);
    }
    if (arguments.json)
    {
        const nlohmann::ordered_json json = {{"directory", result.directory.string()},
                                             {"frames", result.frames},
                                             {"all_frames", result.allFrames},
                                             {"skipped_frames", result.skippedFrames},
                                             {"missing", result.missing},
                                             {"kept_frames", result.keptFrames},
                                             {"ended", result.ended},
                                             {"whole_bytes", result.wholeBytes},
                                             {"file_bytes", result.fileBytes},
                                             {"stopped", result.stopped},
                                             {"renderer", result.renderer},
                                             {"seconds", result.wallSeconds}};
        fmt::print("{}\n", json.dump(2));
    }
    else if (!arguments.quiet)
    {
        printResult(arguments, result);
    }
    if (const auto failure = failureOf(result))
    {
        throw *failure;
    }
    return result.stopped ? static_cast<int>(ErrorCode::stoppedEarly) : 0;
}

void addOutput(CLI::App& command, RenderArguments& arguments)
{
    const char* output = "Output";
    command
        .add_option("--out", arguments.directory,
                    "Directory of the pictures (render, in that of the run)")
        ->type_name("DIR")
        ->group(output);
    command.add_option("--video", arguments.video, "Also make a video of the frames, with ffmpeg")
        ->type_name("FILE.mp4|.webm|.gif")
        ->group(output);
    command
        .add_option("--camera-path", arguments.request.cameraPath,
                    "Move the camera: keyframes SECONDS:AZIMUTH,ELEVATION[,ZOOM] of the video, or "
                    "a file of such lines; otherwise as in the run")
        ->type_name("KEYS|FILE")
        ->group(output);
    command
        .add_flag("--contact-sheet", arguments.request.contactSheet,
                  "Also draw twelve frames in one picture, contact_sheet.png")
        ->group(output);
    command.add_flag("--overwrite", arguments.request.overwrite, "Replace earlier pictures")
        ->group(output);
    command
        .add_flag("--skip-existing", arguments.request.skipExisting,
                  "Keep existing pictures that are complete and of this run, frame and settings; "
                  "not with a video or passes")
        ->group(output);
    command
        .add_option("--shard", arguments.shard,
                    "Draw only the I-th of N parts, beside other processes; slurm: that of this "
                    "task of a job array")
        ->type_name("I/N|slurm")
        ->group(output);
    command
        .add_flag("--gather", arguments.request.gather,
                  "Draw nothing; check that all pictures exist, complete and correct")
        ->group(output);
    command
        .add_flag("--dry-run", arguments.request.dryRun,
                  "Check everything and say what would be done, but write nothing")
        ->group(output);
    arguments.progress.addTo(command, output);
    command.add_flag("--quiet", arguments.quiet, "Print errors only")->group(output);
    command.add_flag("--json", arguments.json, "Print what was drawn as JSON on standard output")
        ->group(output);
}

} // namespace

Command addRenderCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = program.add_subcommand(
        "render", "Draw a kept run again; settings that are not given are those of the run");
    command->footer(kRenderExamples);
    command->add_option("RUN", arguments->run, "Directory of a run that was kept, or its run.frost")
        ->required();
    addPictureOptions(*command, arguments->given);
    addOutput(*command, *arguments);
    return [arguments]
    { return arguments->progress.endWith([&] { return runRender(*arguments); }); };
}

} // namespace frostfill

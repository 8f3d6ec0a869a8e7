// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/message.hpp"
#include "app/progress.hpp"
#include "app/scene_options.hpp"
#include "app/stop_signals.hpp"

#include <frostfill/error.hpp>
#include <frostfill/render_run.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace frostfill
{
namespace
{

constexpr const char* kExamples = R"(Examples:
  frostfill render output/torus                            the same pictures, in output/torus/render
  frostfill render output/torus --frames last --size 3840x2160 --style studio --out poster
  frostfill render output/torus --frames 100..200 --turntable 8 --video turn.mp4
  frostfill render output/torus --skip-existing            go on after a kill
)";

struct RenderArguments
{
    RenderRequest request;
    std::string run;
    std::string directory;
    std::string video;
    bool quiet = false;
    bool json = false;
    GivenOptions given;
};

void printResult(const RenderArguments& arguments, const RenderResult& result)
{
    if (result.wholeBytes < result.fileBytes)
    {
        say(fmt::format("{} is torn: {} of its {} bytes are whole, with {} frames; the rest is "
                        "left out\n",
                        arguments.run, result.wholeBytes, result.fileBytes, result.keptFrames));
    }
    else if (!result.ended)
    {
        say(fmt::format("the run in {} has not ended: there are {} frames so far\n", arguments.run,
                        result.keptFrames));
    }
    fmt::print("{} pictures{}; {:.1f} s; results in {}\n", result.frames,
               result.skippedFrames > 0
                   ? fmt::format(", of which {} were there already", result.skippedFrames)
                   : "",
               result.wallSeconds, result.directory.string());
}

int runRender(const RenderArguments& arguments)
{
    RenderRequest request = arguments.request;
    request.run = arguments.run;
    request.directory = arguments.directory;
    request.video = arguments.video;
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
    catchStopSignals();
    const RenderResult result = renderRun(request, observer);
    bar.close();

    if (arguments.json)
    {
        const nlohmann::ordered_json json = {{"directory", result.directory.string()},
                                             {"frames", result.frames},
                                             {"skipped_frames", result.skippedFrames},
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
    if (result.blank)
    {
        throw Error(ErrorCode::postcondition,
                    fmt::format("the pictures are blank: the camera does not see the object; they "
                                "are in {}",
                                result.directory.string()));
    }
    if (result.videoFailure)
    {
        throw Error(ErrorCode::writeFailed,
                    fmt::format("{}; the frames are in {}", *result.videoFailure,
                                result.directory.string()));
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
                  "Also show twelve frames in one picture, contact_sheet.png")
        ->group(output);
    command.add_flag("--overwrite", arguments.request.overwrite, "Replace earlier pictures")
        ->group(output);
    command
        .add_flag("--skip-existing", arguments.request.skipExisting,
                  "Leave pictures that are there, whole, and of this run, frame and settings; not "
                  "with a video or passes")
        ->group(output);
    command.add_flag("--quiet", arguments.quiet, "Print errors only")->group(output);
    command.add_flag("--json", arguments.json, "Print what was drawn as JSON on standard output")
        ->group(output);
}

} // namespace

Command addRenderCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = program.add_subcommand(
        "render", "Draw a run again that was kept; what is not given is as in the run");
    command->footer(kExamples);
    command->add_option("RUN", arguments->run, "Directory of a run that was kept, or its run.frost")
        ->required();
    addPictureOptions(*command, arguments->given);
    addOutput(*command, *arguments);
    return [arguments] { return runRender(*arguments); };
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/export_files.hpp"
#include "app/fill_request.hpp"
#include "app/fill_text.hpp"
#include "app/progress/json_progress.hpp"
#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/scene_options.hpp"
#include "app/text/shell_text.hpp"
#include "app/view_text.hpp"
#include "run/recording.hpp"
#include "run/resume.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/options.hpp>
#include <frostfill/plan_fill.hpp>
#include <frostfill/volume_estimate.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kFillExamples = R"(Examples:
  frostfill fill torus                           the paper's run, with frames
  frostfill fill human --frames none             tables, no pictures
  frostfill fill part.stl --up z --units mm --count 500
  frostfill fill bunny.obj --radius 0.02 --out output/fine
  frostfill fill bust.stl --lid                  close a large opening first
  frostfill fill cube --radius 0.04..0.12        radii drawn from a range
  frostfill fill --scene output/torus/summary.json --out output/again
  frostfill fill --resume output/torus           go on after a kill or a stop
  frostfill fill torus --view                    also a page for any browser: output/torus/view.html
)";

int printVolume(const FillArguments& arguments)
{
    Scene scene = requestedScene(arguments);
    warnOfIgnored(arguments, scene.preset);
    // No frames are drawn, so the fastest motion is enough.
    if (scene.preset == Preset::fast && arguments.sceneFile.empty() &&
        !arguments.given.contains(&optionOf("motion.mode")))
    {
        scene.motion.mode = Motion::descend;
    }
    const VolumeEstimate estimate = estimateVolume(scene);
    if (arguments.json)
    {
        const nlohmann::ordered_json json = {
            {"volume_estimate", estimate.volume},
            {"volume_estimate_error", estimate.error},
            {"volume_mesh", estimate.meshVolume},
            {"radius", estimate.radius},
            {"radius_times_area_over_volume", estimate.radiusTimesAreaOverVolume},
            {"spheres_of_radius", estimate.coarse},
            {"spheres_of_half_radius", estimate.fine}};
        fmt::print("{}\n", json.dump(2));
        return 0;
    }
    fmt::print(
        "volume {:.5g} +- {:.2g}, from {} spheres of radius {:.5g} and {} of half that radius\n",
        estimate.volume, estimate.error, estimate.coarse, estimate.radius, estimate.fine);
    fmt::print("the mesh has {:.5g}; the estimate differs by {:+.2f} %\n", estimate.meshVolume,
               100 * (estimate.volume / estimate.meshVolume - 1));
    return 0;
}

/// The page of a run that has just been written replaces that of an earlier one. Returns what went
/// wrong, which matters less than what went wrong with the run.
std::optional<Error> writePageOf(const std::filesystem::path& run, const FillArguments& arguments)
{
    if (!arguments.view)
    {
        return std::nullopt;
    }
    PageRequest page;
    page.run = run;
    page.overwrite = true;
    page.fullMesh = arguments.fullMesh;
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
        !arguments.video.empty() || !arguments.cameraPath.empty() || arguments.contactSheet;
    return request.resume && !draws && !outcome.empty() && outcome != "stopped" &&
           meshOfEarlierRun(request).has_value();
}

/// Names are checked before the run. What an earlier run has exported is replaced, as the run is.
std::vector<ExportRequest> exportsOf(const FillArguments& arguments, const FillRequest& request)
{
    std::vector<ExportRequest> exports =
        exportRequests(request.directory, arguments.exports, request.directory / "export");
    for (ExportRequest& each : exports)
    {
        each.overwrite = true;
        each.fullMesh = arguments.fullMesh;
    }
    return exports;
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

FillObserver observerOf(FillArguments& arguments, const FillRequest& request, ProgressBar& bar)
{
    FillObserver observer;
    observer.loaded = [&]
    {
        runHasBegun();
        arguments.progress.show("preparing", 0, 1, "steps");
    };
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
    if (arguments.progress.wanted())
    {
        arguments.progress.show("loading", 0, 1, "steps");
        observer.progressed = [&](const FillProgress& progress)
        { arguments.progress.show(progress); };
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

/// What the options ask for that the run could not give in the end.
void requireKeptRun(const FillArguments& arguments, const FillRequest& request)
{
    if (arguments.view && !isKept(request.scene))
    {
        throw Error(ErrorCode::usage, "--view shows the run file, which this run does not write: "
                                      "add --keep-run on, or omit --view");
    }
    if (!arguments.exports.empty() && !isKept(request.scene))
    {
        throw Error(ErrorCode::usage, "--export reads the run file: omit --keep-run off, or give "
                                      "--keep-run on with --frames none");
    }
}

int runFill(FillArguments& arguments)
{
    if (arguments.estimateVolume)
    {
        return printVolume(arguments);
    }
    const FillRequest request = requestOf(arguments);
    requireKeptRun(arguments, request);
    const std::vector<ExportRequest> exports = exportsOf(arguments, request);
    warnOfIgnored(arguments, request.scene.preset);
    const std::string outcome = request.resume ? outcomeOfRun(request.directory) : "";
    if (hasEnded(request, arguments, outcome))
    {
        say(fmt::format("the run in {} has ended ({}): nothing to resume\n",
                        request.directory.string(), outcome));
        if (!arguments.dryRun)
        {
            const std::optional<Error> pageFailure = writePageOf(request.directory, arguments);
            exportFiles(exports, arguments.quiet || arguments.json);
            if (pageFailure)
            {
                throw *pageFailure;
            }
        }
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
    std::optional<Error> pageFailure;
    if (!result.stopped)
    {
        pageFailure = writePageOf(result.directory, arguments);
        exportFiles(exports, arguments.quiet || arguments.json);
    }
    return outcomeOf(result, pageFailure);
}

} // namespace

Command addFillCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<FillArguments>();
    CLI::App* command = program.add_subcommand(
        "fill", "Fill a mesh with spheres; write frames, tables and a summary");
    command->footer(kFillExamples);
    command->add_option(
        "MESH", arguments->mesh,
        "torus, sphere, cube, human, a container such as cylinder:1,4, or a mesh file");
    command
        ->add_option("--scene", arguments->sceneFile,
                     "Scene file (TOML), or summary.json of a run to repeat")
        ->type_name("FILE");
    addSceneOptions(*command, arguments->given);
    const char* output = "Output";
    command->add_option("--out", arguments->directory, "Directory of the run (output/NAME)")
        ->type_name("DIR")
        ->group(output);
    command
        ->add_option("--resume", arguments->resume,
                     "Continue the run in this directory, to the same results; give the options of "
                     "the run or none")
        ->type_name("DIR")
        ->group(output);
    command->add_option("--video", arguments->video, "Also make a video of the frames, with ffmpeg")
        ->type_name("FILE.mp4|.webm|.gif")
        ->group(output);
    command
        ->add_option(
            "--camera-path", arguments->cameraPath,
            "Move the camera: keyframes SECONDS:AZIMUTH,ELEVATION[,ZOOM] of the video, such "
            "as \"0:30,20 8:120,45\", or a file of such lines")
        ->type_name("KEYS|FILE")
        ->group(output);
    command
        ->add_option("--export", arguments->exports,
                     fmt::format("Also write the run, into the folder export, as: {}; see "
                                 "frostfill export",
                                 exportFormatNames()))
        ->delimiter(',')
        ->type_name("FORMAT")
        ->group(output);
    command
        ->add_flag("--contact-sheet", arguments->contactSheet,
                   "Also draw twelve frames in one picture, contact_sheet.png")
        ->group(output);
    command
        ->add_flag("--view", arguments->view,
                   "Also write view.html, a page that shows the run in any browser")
        ->group(output);
    command
        ->add_flag("--full-mesh", arguments->fullMesh,
                   fmt::format("{}: in view.html and glTF", kFullMeshHelp))
        ->group(output);
    command
        ->add_flag("--estimate-volume", arguments->estimateVolume,
                   "Fill with r and with r/2, print the estimated volume, write no files")
        ->group(output);
    command->add_flag("--overwrite", arguments->overwrite, "Replace an earlier run")->group(output);
    command
        ->add_flag("--dry-run", arguments->dryRun,
                   "Check everything and say what would be done, but write nothing")
        ->group(output);
    arguments->progress.addTo(*command, output);
    command->add_flag("--quiet", arguments->quiet, "Print errors only")->group(output);
    command->add_flag("--json", arguments->json, "Print the summary as JSON on standard output")
        ->group(output);
    return [arguments] { return arguments->progress.endWith([&] { return runFill(*arguments); }); };
}

} // namespace frostfill

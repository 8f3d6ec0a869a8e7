// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/fill_text.hpp"
#include "app/message.hpp"
#include "app/progress.hpp"
#include "app/scene_options.hpp"
#include "app/stop_signals.hpp"
#include "run/resume.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/options.hpp>
#include <frostfill/volume_estimate.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>

namespace frostfill
{
namespace
{

constexpr const char* kExamples = R"(Examples:
  frostfill fill torus                           the paper's run, with frames
  frostfill fill human --frames none             tables, no pictures
  frostfill fill part.stl --up z --units mm --count 500
  frostfill fill bunny.obj --radius 0.02 --out output/fine
  frostfill fill bust.stl --lid                  close a large opening first
  frostfill fill cube --radius 0.04..0.12        radii drawn from a range
  frostfill fill --scene output/torus/summary.json --out output/again
  frostfill fill --resume output/torus           go on after a kill or a stop
)";

struct FillArguments
{
    std::string mesh;
    std::string sceneFile;
    std::string directory;
    std::string resume;
    std::string video;
    std::string cameraPath;
    bool contactSheet = false;
    bool overwrite = false;
    bool quiet = false;
    bool json = false;
    bool estimateVolume = false;
    GivenOptions given;
};

/// The preset gives all other settings their defaults, so it is read first.
Preset requestedPreset(const GivenOptions& given)
{
    GivenOptions presetAlone;
    if (const auto found = given.find("preset"); found != given.end())
    {
        presetAlone.insert(*found);
    }
    Scene scene;
    applyGivenOptions(presetAlone, scene);
    return scene.preset;
}

Scene requestedScene(const FillArguments& arguments)
{
    if (arguments.mesh.empty() && arguments.sceneFile.empty())
    {
        throw Error(
            ErrorCode::usage,
            "give a MESH (torus, sphere, cube, human or a file), a --scene or a --resume; see "
            "frostfill fill --help");
    }
    Scene scene = arguments.sceneFile.empty()
                      ? presetScene(requestedPreset(arguments.given), arguments.mesh)
                      : loadRunScene(arguments.sceneFile);
    if (!arguments.sceneFile.empty() && !arguments.mesh.empty())
    {
        scene.object.mesh = arguments.mesh;
        scene.name = presetScene(scene.preset, arguments.mesh).name;
    }
    applyGivenOptions(arguments.given, scene);
    if (arguments.sceneFile.empty())
    {
        fillUntilFullForARadiusAlone(arguments.given, scene);
    }
    return scene;
}

// Only for the command line: a scene file has the settings of both presets.
void warnOfIgnored(const FillArguments& arguments, Preset preset)
{
    const std::string ignored = ignoredOptionsText(arguments.given, preset);
    if (!ignored.empty() && !arguments.quiet)
    {
        say(fmt::format("frostfill: warning: {}\n", ignored));
    }
}

int printVolume(const FillArguments& arguments)
{
    Scene scene = requestedScene(arguments);
    warnOfIgnored(arguments, scene.preset);
    // No frames are drawn, so the fastest motion is enough.
    if (scene.preset == Preset::fast && arguments.sceneFile.empty() &&
        !arguments.given.contains("motion.mode"))
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

/// Without a MESH or a scene, the run that is resumed says all.
FillRequest requestOf(const FillArguments& arguments)
{
    if (!arguments.resume.empty() && (!arguments.directory.empty() || arguments.overwrite))
    {
        throw Error(ErrorCode::usage, "--resume names the directory of the run and keeps what is "
                                      "in it: omit --out and --overwrite");
    }
    if (!arguments.resume.empty() && arguments.mesh.empty() && arguments.sceneFile.empty())
    {
        FillRequest request = resumeRequest(arguments.resume);
        applyGivenOptions(arguments.given, request.scene);
        return request;
    }
    FillRequest request;
    request.scene = requestedScene(arguments);
    request.resume = !arguments.resume.empty();
    const std::string& directory = request.resume ? arguments.resume : arguments.directory;
    request.directory = directory.empty() ? std::filesystem::path("output") / request.scene.name
                                          : std::filesystem::path(directory);
    request.overwrite = arguments.overwrite;
    request.video = arguments.video;
    request.contactSheet = arguments.contactSheet;
    request.cameraPath = arguments.cameraPath;
    return request;
}

/// Whether a run that is to be resumed has come to its end before. Throws Error if it is not the
/// one that is requested.
bool hasEnded(const FillRequest& request, const std::string& outcome)
{
    return request.resume && !outcome.empty() && outcome != "stopped" &&
           meshOfEarlierRun(request).has_value();
}

int runFill(const FillArguments& arguments)
{
    if (arguments.estimateVolume)
    {
        return printVolume(arguments);
    }
    const FillRequest request = requestOf(arguments);
    warnOfIgnored(arguments, request.scene.preset);
    const std::string outcome = request.resume ? outcomeOfRun(request.directory) : "";
    if (hasEnded(request, outcome))
    {
        say(fmt::format("the run in {} has ended ({}): nothing to resume\n",
                        request.directory.string(), outcome));
        return outcome == "failed" ? static_cast<int>(ErrorCode::postcondition) : 0;
    }

    ProgressBar bar;
    FillObserver observer;
    observer.loaded = [] { runHasBegun(); };
    observer.stopRequested = &stopRequested;
    if (!arguments.quiet)
    {
        observer.planned = [&](const FillPlan& plan) { printPlan(request, plan); };
        observer.progressed = [&](const FillProgress& progress) { bar.update(progress); };
    }
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
    if (result.failure)
    {
        throw Error(
            ErrorCode::postcondition,
            fmt::format("{}; the files are in {}", *result.failure, result.directory.string()));
    }
    if (result.videoFailure)
    {
        throw Error(ErrorCode::writeFailed,
                    fmt::format("{}; the frames are in {}", *result.videoFailure,
                                result.directory.string()));
    }
    return result.stopped ? static_cast<int>(ErrorCode::stoppedEarly) : 0;
}

} // namespace

Command addFillCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<FillArguments>();
    CLI::App* command = program.add_subcommand(
        "fill", "Fill a mesh with spheres; write frames, tables and a summary");
    command->footer(kExamples);
    command->add_option("MESH", arguments->mesh, "torus, sphere, cube, human, or a mesh file");
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
                     "Go on with the run in this directory, to the same results; with the options "
                     "of the run or none")
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
        ->add_flag("--contact-sheet", arguments->contactSheet,
                   "Also show twelve frames in one picture, contact_sheet.png")
        ->group(output);
    command
        ->add_flag("--estimate-volume", arguments->estimateVolume,
                   "Fill with r and with r/2, print the estimated volume, write no files")
        ->group(output);
    command->add_flag("--overwrite", arguments->overwrite, "Replace an earlier run")->group(output);
    command->add_flag("--quiet", arguments->quiet, "Print errors only")->group(output);
    command->add_flag("--json", arguments->json, "Print the summary as JSON on standard output")
        ->group(output);
    return [arguments] { return runFill(*arguments); };
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/out_file.hpp"
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
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kRenderExamples = R"(Examples:
  frostfill render output/torus                     the same pictures, in output/torus/render
  frostfill render output/torus --out cover.png --size 3840x2160 --style studio
  frostfill render output/torus --frames last --turntable 6 --out turn.mp4
  frostfill render output/torus --skip-existing     go on after a kill
  frostfill render output/torus --shard 3/16        the third of sixteen parts of the pictures
  frostfill render output/torus --gather            whether all pictures are there)";

struct RenderArguments
{
    RenderRequest request;
    std::string run;
    std::string out;
    std::string video;
    std::string shard;
    bool quiet = false;
    bool json = false;
    GivenOptions given;
};

void printResult(const RenderArguments& arguments, const RenderResult& result)
{
    if (result.wholeBytes < result.fileBytes)
    {
        say(fmt::format("{} is incomplete: {} of its {} bytes can be read, with {}; the "
                        "rest is left out\n",
                        arguments.run, result.wholeBytes, result.fileBytes,
                        counted(result.keptFrames, "frame")));
    }
    else if (!result.ended)
    {
        say(fmt::format("the run in {} has not ended: it has {} so far\n", arguments.run,
                        counted(result.keptFrames, "frame")));
    }
    if (arguments.request.dryRun)
    {
        fmt::print("nothing was written; {} would be drawn into {}\n",
                   counted(result.frames, "picture"), result.directory.string());
        return;
    }
    if (arguments.request.gather)
    {
        fmt::print("all {} pictures are in {}\n", result.allFrames, result.directory.string());
        return;
    }
    fmt::print("{}{}; {:.1f} s; results in {}\n",
               result.frames < result.allFrames
                   ? fmt::format("{} of {}", result.frames, counted(result.allFrames, "picture"))
                   : counted(result.frames, "picture"),
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

/// Where the pictures are from which a file is made, and which go with their owner.
class PicturesOfFile
{
public:
    explicit PicturesOfFile(const std::filesystem::path& file)
        : folder_(file.parent_path() / fmt::format(".{}.frames", file.filename().string()))
    {
    }
    ~PicturesOfFile()
    {
        std::error_code none;
        std::filesystem::remove_all(folder_, none);
    }
    PicturesOfFile(const PicturesOfFile&) = delete;
    PicturesOfFile& operator=(const PicturesOfFile&) = delete;
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

/// Returns the request without the changes of the scene. Throws Error usage.
RenderRequest requestOf(const RenderArguments& arguments, OutKind kind)
{
    RenderRequest request = arguments.request;
    request.run = arguments.run;
    request.directory = arguments.out;
    request.video = arguments.video;
    request.shard = arguments.shard.empty() ? Shard{} : parseShard(arguments.shard);
    if (request.overwrite && request.skipExisting)
    {
        throw Error(ErrorCode::usage, "--overwrite removes what --skip-existing would skip: omit "
                                      "one of them");
    }
    if (kind == OutKind::page)
    {
        throw Error(ErrorCode::usage, fmt::format("a page is written by frostfill view {} --out {}",
                                                  arguments.run, arguments.out));
    }
    if (kind != OutKind::folder && (request.skipExisting || request.gather ||
                                    !arguments.shard.empty() || !arguments.video.empty()))
    {
        throw Error(ErrorCode::usage, "--out names a file: omit --video, --skip-existing, --shard "
                                      "and --gather, or give a folder");
    }
    if (kind == OutKind::video)
    {
        request.video = arguments.out;
    }
    return request;
}

RenderObserver observerOf(const RenderArguments& arguments, TaskBar& bar)
{
    RenderObserver observer;
    observer.stopRequested = &stopRequested;
    if (!arguments.quiet)
    {
        observer.progressed = [&](std::size_t done, std::size_t all)
        { bar.update(done, all, "frames"); };
    }
    return observer;
}

void printJson(const RenderResult& result)
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

int runRender(const RenderArguments& arguments)
{
    const OutKind kind = outKind(arguments.out, arguments.request.overwrite);
    RenderRequest request = requestOf(arguments, kind);
    std::optional<PicturesOfFile> pictures;
    if (kind != OutKind::folder)
    {
        pictures.emplace(arguments.out);
        request.directory = pictures->folder();
        request.overwrite = true; // of what a killed process has left
    }
    std::string implied;
    request.change = [&](Scene& scene)
    {
        applyGivenOptions(arguments.given, scene);
        if (kind == OutKind::picture)
        {
            implied = showOnePicture(arguments.given, scene);
        }
        if (!scene.frames.enabled)
        {
            throw Error(ErrorCode::usage, "--frames none leaves nothing to draw");
        }
        runHasBegun();
    };
    TaskBar bar;
    catchStopSignals();
    RenderResult result = renderRun(request, observerOf(arguments, bar));
    bar.close();
    if (!implied.empty() && !arguments.quiet)
    {
        say(fmt::format("frostfill: {}\n", implied));
    }
    if (kind == OutKind::picture && result.frames > 0 && !request.dryRun)
    {
        copyPicture(result.directory, arguments.out);
    }
    if (kind != OutKind::folder)
    {
        result.directory = arguments.out;
    }
    if (request.gather)
    {
        requireAll(result);
    }
    if (arguments.json)
    {
        printJson(result);
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
    RenderRequest& request = arguments.request;
    const auto add = [&](const char* name, std::string& value, const char* help, const char* type)
    { command.add_option(name, value, help)->type_name(type)->group("Output"); };
    const auto addFlag = [&](const char* name, bool& value, const char* help)
    { command.add_flag(name, value, help)->group("Output"); };
    add("--out", arguments.out,
        "Folder of the pictures (render, in that of the run), or a file: .mp4, .webm, .gif, .png",
        "DIR|FILE");
    add("--video", arguments.video,
        "Also make a video: .mp4, .webm, .gif, or - for standard output", "FILE");
    addFlag("--overwrite", request.overwrite, "Replace earlier pictures");
    addFlag("--skip-existing", request.skipExisting,
            "Keep pictures that are complete and of this run, frame and settings");
    add("--shard", arguments.shard,
        "Draw the I-th of N parts, beside other processes; slurm: that of this task of an array",
        "I/N|slurm");
    addFlag("--gather", request.gather, "Draw nothing; check that all pictures are there");
    addFlag("--dry-run", request.dryRun, "Check all and say what would be done; write nothing");
    addFlag("--quiet", arguments.quiet, "Print errors only");
    addFlag("--json", arguments.json, "Print what was drawn as JSON on standard output");
}

} // namespace

Command addRenderCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = program.add_subcommand(
        "render", "Draw a kept run again; settings that are not given are those of the run");
    command->footer(kRenderExamples);
    command->add_option("RUN", arguments->run, "Folder of a run that was kept, or its run.frost")
        ->required();
    addSceneOptions(*command, arguments->given);
    addOutput(*command, *arguments);
    return [arguments] { return runRender(*arguments); };
}

} // namespace frostfill

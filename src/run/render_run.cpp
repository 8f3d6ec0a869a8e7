// SPDX-License-Identifier: MIT
#include "output/scene_json.hpp"
#include "run/frame_painter.hpp"
#include "run/frame_timing.hpp"
#include "run/frame_writer.hpp"
#include "run/run_directory.hpp"
#include "run/run_head.hpp"
#include "run_file/file_of_run.hpp"

#include <frostfill/error.hpp>
#include <frostfill/output.hpp>
#include <frostfill/render_run.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <vector>

namespace frostfill
{
namespace
{

/// Frames of the animation in a run file. Behind them, once the run has ended, is the last state
/// under the next number: nearly always the state of the last frame once more. In a run that has
/// not ended, the last of them shows it.
std::size_t framesOf(const RunFileReader& reader)
{
    return reader.frames().size() - (reader.summary() ? 1 : 0);
}

/// The scene that is drawn. Says whether the request moves the camera, rather than the run.
Scene sceneOf(const RenderRequest& request, const RunHead& head, bool& moves)
{
    Scene scene = head.scene;
    scene.frames.enabled = true;
    Scene still = scene;
    still.camera.turntable.reset();
    still.frames.cameraPath.reset();
    if (request.change)
    {
        request.change(scene);
        request.change(still);
    }
    moves = still.camera.turntable || still.frames.cameraPath;
    if (moves) // in place of how the run moves it
    {
        scene.camera.turntable = still.camera.turntable;
        scene.frames.cameraPath = still.frames.cameraPath;
    }
    validateScene(scene);
    requireBackgroundOf(request.video, scene);
    return scene;
}

/// Counts the frames that are selected. Throws Error usage when there is none.
std::size_t selectedFrames(const Scene& scene, const RunFileReader& reader, PicturePlan counted)
{
    for (std::size_t i = 0; i < framesOf(reader); ++i)
    {
        counted.pass(reader.frames()[i]);
    }
    counted.passLast(reader.frames().back());
    if (counted.selected() == 0)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--frames {} leaves no frame: the frames of the run file have the "
                                "numbers 0 to {}",
                                scene.frames.selection, reader.frames().back()));
    }
    return counted.selected();
}

/// Every n-th selected frame is kept: as `fill` did for the same selection, or as the limit
/// asks for.
std::size_t strideOf(const Scene& scene, const RunHead& head, std::size_t selected)
{
    const FrameSettings& then = head.scene.frames;
    const FrameSettings& now = scene.frames;
    const bool same = then.enabled && then.selection == now.selection && then.limit == now.limit &&
                      then.hold == now.hold && then.fps == now.fps;
    const bool last = framesToDraw(scene).hasLast();
    return same ? head.stride : strideFor(selected + (last ? 1 : 0), now.limit, last);
}

/// Plans all pictures of a rendering, before the first is drawn.
void planAll(PicturePlan& plan, const std::filesystem::path& file)
{
    RunFileReader reader(file);
    const std::vector<std::size_t>& numbers = reader.frames();
    for (std::size_t i = 0; i < framesOf(reader); ++i)
    {
        plan.wants(numbers[i]) ? void(plan.take(numbers[i], i)) : plan.pass(numbers[i]);
    }
    if (plan.wantsLast(numbers.back()))
    {
        const std::size_t last = numbers.size() - 1;
        const std::size_t kept = plan.keptState().value_or(last);
        const std::uint64_t revision = reader.seek(kept).revision;
        plan.finish(numbers.back(), reader.seek(last).revision == revision ? kept : last, {},
                    [](const PicturePlan::Picture&) {});
    }
}

/// Pictures in a folder that are of none of these frames.
std::size_t picturesBeside(const std::vector<std::size_t>& frames,
                           const std::filesystem::path& folder)
{
    std::set<std::string> names;
    for (const std::size_t frame : frames)
    {
        names.insert(PngSequence::fileName(frame));
    }
    std::size_t surplus = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        const std::string name = entry.path().filename().string();
        surplus += PngSequence::endingOf(name) == ".png" && !names.contains(name) ? 1 : 0;
    }
    return surplus;
}

/// Throws Error usage for wishes that only one process can meet.
void requireOneProcess(const RenderRequest& request)
{
    if (request.shard.count > 1 && (!request.video.empty() || request.overwrite))
    {
        throw Error(ErrorCode::usage, "one part of the pictures makes no video, and cannot replace "
                                      "pictures of other parts: omit --video and --overwrite");
    }
    if (request.gather && (!request.video.empty() || request.overwrite || request.shard.count > 1))
    {
        throw Error(ErrorCode::usage, "--gather draws nothing: omit --video, --overwrite and "
                                      "--shard");
    }
}

EarlierRun earlierPictures(const RenderRequest& request)
{
    if (request.shard.count > 1 || request.gather)
    {
        return EarlierRun::share;
    }
    return request.skipExisting ? EarlierRun::keep
           : request.overwrite  ? EarlierRun::replace
                                : EarlierRun::refuse;
}

/// What the run file says before a picture is drawn.
RenderResult resultOf(RunFileReader& reader, const std::filesystem::path& directory)
{
    RenderResult result;
    result.directory = directory;
    result.ended = reader.summary().has_value();
    result.wholeBytes = reader.wholeBytes();
    result.fileBytes = reader.fileBytes();
    result.keptFrames = framesOf(reader);
    return result;
}

/// Where the pictures go. Throws Error usage for the directory of the run itself.
std::filesystem::path directoryOf(const RenderRequest& request, const std::filesystem::path& file)
{
    const std::filesystem::path home = file.parent_path().empty() ? "." : file.parent_path();
    std::filesystem::path directory =
        request.directory.empty() ? home / "render" : request.directory;
    std::error_code none;
    if (std::filesystem::equivalent(directory, home, none))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} is the directory of the run itself; give another one with "
                                "--out",
                                directory.string()));
    }
    if (request.gather && !std::filesystem::is_directory(directory / "frames", none))
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("{} has no pictures to gather", directory.string()));
    }
    return directory;
}

/// Draws all frames, about as many pictures as are expected. Returns whether it was stopped.
bool drawFrames(FramePainter& painter, RunFileReader& reader, std::size_t expected,
                const RenderObserver& observer)
{
    const std::vector<std::size_t>& numbers = reader.frames();
    std::size_t done = 0;
    const auto progressed = [&]
    {
        ++done;
        if (observer.progressed)
        {
            observer.progressed(done, std::max(done, expected));
        }
    };
    for (std::size_t i = 0; i < framesOf(reader); ++i)
    {
        if (observer.stopRequested && observer.stopRequested())
        {
            return true;
        }
        if (!painter.plan().wants(numbers[i]))
        {
            painter.plan().pass(numbers[i]);
            continue;
        }
        const std::size_t leftOut = painter.drawn().leftOut();
        painter.take(numbers[i], reader.seek(i));
        painter.wait();
        if (painter.drawn().leftOut() == leftOut)
        {
            reader.forgetChanges();
        }
        progressed();
    }
    const bool wantsLast = painter.plan().wantsLast(numbers.back());
    painter.finish(numbers.back(), wantsLast ? &reader.seek(numbers.size() - 1) : nullptr,
                   progressed);
    return false;
}

} // namespace

RenderResult renderRun(const RenderRequest& request, const RenderObserver& observer)
{
    const auto start = std::chrono::steady_clock::now();
    const std::filesystem::path file = fileOfRun(request.run);
    RunFileReader reader(file);
    const RunHead head = readHead(reader.head(), file.string());
    requireFrames(reader, file);
    bool moves = false;
    const Scene scene = sceneOf(request, head, moves);
    requireOneProcess(request);
    const std::filesystem::path directory = directoryOf(request, file);
    const std::optional<CameraPath> path = CameraPath::of(scene);
    // A run of one state is its turn.
    const std::size_t turn =
        moves || reader.frames().back() == 0 ? turnFrames(scene, path ? path->duration() : 0) : 0;
    PicturePlan pictures(scene, turn);
    const std::size_t selected = selectedFrames(scene, reader, pictures);
    pictures.keepEvery(strideOf(scene, head, selected));
    const bool isPart = request.shard.count > 1 || request.gather;
    if (isPart || request.dryRun)
    {
        planAll(pictures, file);
    }
    if (request.dryRun)
    {
        RunDirectory::check(directory, earlierPictures(request));
        const auto [first, end] = request.shard.range(pictures.count());
        RenderResult plan = resultOf(reader, directory);
        plan.allFrames = pictures.count();
        plan.frames = end - first;
        return plan;
    }
    RunDirectory place(directory, earlierPictures(request));
    PaintRequest paint = {reader.mesh(),
                          scene,
                          colourRange(scene, head.colours),
                          head.poses,
                          runHash(scene, reader.mesh()),
                          directory,
                          request.video,
                          path,
                          turn,
                          request.skipExisting || isPart};
    if (isPart)
    {
        paint.pictures = request.shard.range(pictures.count());
        paint.onlyLook = request.gather;
    }
    FramePainter painter(paint);
    painter.stopWhen(observer.stopRequested);
    painter.plan().keepEvery(pictures.stride());
    place.begin();

    RenderResult result = resultOf(reader, directory);
    const std::size_t stride = request.video.empty() ? pictures.stride() : 1;
    result.stopped = drawFrames(painter, reader, (selected + stride - 1) / stride, observer);
    result.allFrames = painter.plan().count();
    const DrawnPictures& drawn = painter.drawn();
    result.frames = result.allFrames - drawn.others;
    result.missing = drawn.missing;
    result.surplus = request.gather ? picturesBeside(drawn.numbers, directory / "frames") : 0;
    result.skippedFrames = drawn.skipped;
    result.renderer = drawn.renderer;
    if (!result.stopped)
    {
        result.videoFailure = drawn.videoFailure;
        result.blank = drawn.blank;
    }
    result.wallSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace frostfill

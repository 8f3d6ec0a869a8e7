// SPDX-License-Identifier: MIT
#include "run/contact_sheet.hpp"
#include "run/frame_painter.hpp"
#include "run/frame_timing.hpp"
#include "run/resume.hpp"
#include "run/run_directory.hpp"
#include "run/run_hash.hpp"
#include "run/run_head.hpp"
#include "run_file/file_of_run.hpp"
#include "run_file/kept_frames.hpp"

#include <frostfill/error.hpp>
#include <frostfill/output.hpp>
#include <frostfill/render_run.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>

#include <chrono>
#include <set>
#include <utility>
#include <vector>

namespace frostfill
{
namespace
{

/// The camera's path: the one asked for, or that of the run unless a turntable was asked for.
std::optional<CameraPath> cameraPath(const RenderRequest& request, const RunHead& head,
                                     const Scene& scene)
{
    if (!request.cameraPath.empty() && scene.camera.turntable)
    {
        throw Error(ErrorCode::usage,
                    "--camera-path and --turntable both move the camera: omit one of them");
    }
    const std::string& text = !request.cameraPath.empty() || scene.camera.turntable
                                  ? request.cameraPath
                                  : head.cameraPath;
    return text.empty() ? std::nullopt : std::optional(CameraPath::read(text));
}

FramePainter::State toPaint(const Snapshot& snapshot, const RunFileReader& reader)
{
    return {&snapshot, reader.revision()};
}

/// Every n-th selected frame is kept: as `fill` did for the same selection, or as the limit
/// asks for. Throws Error usage when no frame is left.
std::size_t strideOf(const Scene& scene, const RunHead& head, const KeptFrames& frames, double path)
{
    const FrameSelection selection = framesToDraw(scene);
    const std::size_t held = heldFrames(scene, path);
    std::size_t selected = selection.isLastOnly() ? std::max<std::size_t>(1, held) : 0;
    if (!selection.isLastOnly())
    {
        for (std::size_t i = 0; i < frames.count(); ++i)
        {
            selected += selection.has(frames.number(i)) ? 1 : 0;
        }
        for (std::size_t k = 0; k < held; ++k)
        {
            selected += selection.hasLast() || selection.has(frames.end() + k) ? 1 : 0;
        }
    }
    selected += selection.hasLast() && selected == 0 ? 1 : 0;
    if (selected == 0)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--frames {} leaves no frame: the run file has {} frames, up to "
                                "number {}",
                                scene.frames.selection, frames.count(), frames.end()));
    }
    const FrameSettings& then = head.scene.frames;
    const FrameSettings& now = scene.frames;
    const bool same = then.enabled && then.selection == now.selection && then.limit == now.limit &&
                      then.hold == now.hold && then.fps == now.fps;
    return same ? head.stride
                : strideFor(selected + (selection.hasLast() ? 1 : 0), now.limit,
                            selection.hasLast());
}

/// The pictures of a rendering, before the first is drawn.
struct PictureCount
{
    std::size_t stride = 1; ///< every stride-th of the selected frames is kept in the end
    std::size_t count = 0;
};

/// Takes the frames as the painter does, but draws none. `stride`: with which it begins.
PictureCount countPictures(const std::filesystem::path& file, const Scene& scene,
                           std::size_t stride, double path)
{
    RunFileReader reader(file);
    const KeptFrames frames(reader);
    const FrameSelection selection = framesToDraw(scene);
    const std::size_t last = reader.frames().size() - 1;
    std::vector<std::size_t> states; // of the selected frames, by their place in the file
    for (std::size_t i = 0; i < frames.count(); ++i)
    {
        if (selection.has(frames.number(i)))
        {
            states.push_back(i);
        }
    }
    const std::size_t end = selection.isLastOnly() ? 0 : frames.end();
    for (std::size_t k = 0; k < heldFrames(scene, path); ++k)
    {
        if (selection.hasLast() || selection.has(end + k))
        {
            states.push_back(last);
        }
    }
    FrameThinning thinning(scene.frames.limit);
    thinning.keepEvery(stride);
    std::optional<std::size_t> kept;
    for (std::size_t n = 0; n < states.size(); ++n)
    {
        kept = thinning.take(n).keep ? states[n] : kept;
    }
    const auto revision = [&](std::size_t state)
    {
        (void)reader.seek(state);
        return reader.revision();
    };
    if (selection.hasLast() && (!kept || revision(*kept) != revision(last)))
    {
        std::size_t number = states.size();
        do
        {
            const std::size_t step = thinning.stride();
            number = (number + step - 1) / step * step;
            (void)thinning.take(number);
        } while (!thinning.wants(number));
    }
    return {thinning.stride(), thinning.count()};
}

/// Pictures in a folder that are none of the first `count`.
std::size_t picturesBeyond(std::size_t count, const std::filesystem::path& folder)
{
    std::set<std::string> names;
    for (std::size_t i = 0; i < count; ++i)
    {
        names.insert(PngSequence::fileName(i));
    }
    std::size_t surplus = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        const std::string name = entry.path().filename().string();
        surplus +=
            name.starts_with("frame_") && name.ends_with(".png") && !names.contains(name) ? 1 : 0;
    }
    return surplus;
}

/// Throws Error usage for wishes that only one process can meet.
void requireOneProcess(const RenderRequest& request)
{
    if (request.shard.count > 1 &&
        (!request.video.empty() || request.contactSheet || request.overwrite))
    {
        throw Error(ErrorCode::usage,
                    "one part of the pictures makes no video and no contact sheet, and cannot "
                    "replace pictures of other parts: omit --video, --contact-sheet and "
                    "--overwrite; --gather makes the contact sheet of all");
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
    result.keptFrames = KeptFrames(reader).count();
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

/// Draws all frames. Returns whether it was stopped.
bool drawFrames(FramePainter& painter, RunFileReader& reader, KeptFrames& frames,
                const RenderObserver& observer)
{
    for (std::size_t i = 0; i < frames.count(); ++i)
    {
        if (observer.stopRequested && observer.stopRequested())
        {
            return true;
        }
        if (!painter.wants(frames.number(i)))
        {
            painter.pass(frames.number(i));
            continue;
        }
        const std::size_t leftOut = painter.leftOut();
        painter.take(frames.number(i), toPaint(frames.state(i), reader));
        painter.wait();
        if (painter.leftOut() == leftOut)
        {
            reader.forgetChanges();
        }
        if (observer.progressed)
        {
            observer.progressed(i + 1, frames.count());
        }
    }
    painter.finish(frames.end(),
                   painter.wantsLast() ? toPaint(frames.last(), reader) : FramePainter::State{});
    return false;
}

} // namespace

RenderResult renderRun(const RenderRequest& request, const RenderObserver& observer)
{
    const auto start = std::chrono::steady_clock::now();
    requireOneProcess(request);
    const std::filesystem::path file = fileOfRun(request.run);
    RunFileReader reader(file);
    const RunHead head = readHead(reader.head(), file.string());
    requireFrames(reader, file);
    Scene scene = head.scene;
    scene.frames.enabled = true;
    if (request.change)
    {
        request.change(scene);
    }
    validateScene(scene);
    const std::filesystem::path directory = directoryOf(request, file);
    const std::optional<CameraPath> path = cameraPath(request, head, scene);
    KeptFrames frames(reader);
    const double duration = path ? path->duration() : 0;
    PictureCount pictures = {strideOf(scene, head, frames, duration), 0};
    const bool isPart = request.shard.count > 1 || request.gather;
    if (isPart || request.dryRun)
    {
        pictures = countPictures(file, scene, pictures.stride, duration);
    }
    if (request.dryRun)
    {
        RunDirectory::check(directory, earlierPictures(request));
        const auto [first, end] = request.shard.range(pictures.count);
        RenderResult plan = resultOf(reader, directory);
        plan.allFrames = pictures.count;
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
                          request.skipExisting || isPart};
    if (isPart)
    {
        paint.pictures = request.shard.range(pictures.count);
        paint.onlyLook = request.gather;
    }
    FramePainter painter(paint);
    painter.stopWhen(observer.stopRequested);
    painter.keepEvery(pictures.stride);
    place.begin();

    RenderResult result = resultOf(reader, directory);
    result.stopped = drawFrames(painter, reader, frames, observer);
    result.allFrames = painter.count();
    result.frames = painter.count() - painter.others();
    result.missing = painter.missing();
    result.surplus = request.gather ? picturesBeyond(painter.count(), directory / "frames") : 0;
    result.skippedFrames = painter.skipped();
    result.renderer = painter.description();
    if (!result.stopped)
    {
        result.videoFailure = painter.videoFailure();
        result.blank = painter.blank();
        if (request.contactSheet && result.missing.empty())
        {
            writeContactSheet(scene, directory, painter);
        }
    }
    result.wallSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace frostfill

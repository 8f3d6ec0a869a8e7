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
#include <frostfill/render_run.hpp>
#include <frostfill/run_file.hpp>

#include <fmt/format.h>

#include <chrono>
#include <utility>

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

/// Every so manieth selected frame is kept: as `fill` did for the same selection, or as the limit
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
        const std::size_t skipped = painter.skipped();
        painter.take(frames.number(i), toPaint(frames.state(i), reader));
        painter.wait();
        if (painter.skipped() == skipped)
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
    const std::filesystem::path file = fileOfRun(request.run);
    RunFileReader reader(file);
    const RunHead head = readHead(reader.head(), file.string());
    if (reader.frames().empty())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' has no frame yet: its run was killed as it began; resume it "
                                "with frostfill fill --resume",
                                file.string()));
    }
    Scene scene = head.scene;
    scene.frames.enabled = true;
    if (request.change)
    {
        request.change(scene);
    }
    validateScene(scene);
    const std::filesystem::path home = file.parent_path().empty() ? "." : file.parent_path();
    const std::filesystem::path directory =
        request.directory.empty() ? home / "render" : request.directory;
    std::error_code none;
    if (std::filesystem::equivalent(directory, home, none))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} is the directory of the run itself; give another one with "
                                "--out",
                                directory.string()));
    }
    const std::optional<CameraPath> path = cameraPath(request, head, scene);
    KeptFrames frames(reader);
    const std::size_t stride = strideOf(scene, head, frames, path ? path->duration() : 0);

    RunDirectory place(directory, request.skipExisting ? EarlierRun::keep
                                  : request.overwrite  ? EarlierRun::replace
                                                       : EarlierRun::refuse);
    FramePainter painter({reader.mesh(), scene, colourRange(scene, head.colours), head.poses,
                          runHash(scene, reader.mesh()), directory, request.video, path,
                          request.skipExisting});
    painter.stopWhen(observer.stopRequested);
    painter.keepEvery(stride);
    place.begin();

    RenderResult result;
    result.directory = directory;
    result.ended = reader.summary().has_value();
    result.wholeBytes = reader.wholeBytes();
    result.fileBytes = reader.fileBytes();
    result.keptFrames = frames.count();
    result.stopped = drawFrames(painter, reader, frames, observer);
    result.frames = painter.count();
    result.skippedFrames = painter.skipped();
    result.renderer = painter.description();
    if (!result.stopped)
    {
        result.videoFailure = painter.videoFailure();
        result.blank = painter.blank();
        if (request.contactSheet)
        {
            writeContactSheet(scene, directory, painter);
        }
    }
    result.wallSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace frostfill

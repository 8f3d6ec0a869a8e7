// SPDX-License-Identifier: MIT
#include "run/frame_timing.hpp"

#include "scene/usual_duration.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kDrawnFall = 1;   // [s] of video, of falls that are drawn but not simulated
constexpr double kSlowestFall = 3; // [s] of video, through the object, unless asked for
// Frames that more may come than a model of the run has told [1].
constexpr double kMoreThanModel = 1.25;
// What a picture takes as a PNG: the mean over runs of torus and human at 1280x720.
constexpr double kBytesPerPixel = 0.33;
constexpr double kMaxFrames = 9e15; // exact and in range

std::size_t framesIn(double seconds, const Scene& scene)
{
    return static_cast<std::size_t>(std::min(std::round(seconds * scene.frames.fps), kMaxFrames));
}

/// Pictures that remain of so many frames. The last state is kept whatever its number.
std::size_t keptOf(std::size_t frames, std::size_t stride, bool last)
{
    const std::size_t kept = (frames + stride - 1) / stride;
    return kept + (last && frames > 0 && (frames - 1) % stride != 0 ? 1 : 0);
}

} // namespace

std::size_t strideFor(std::size_t frames, std::size_t limit, bool last)
{
    if (limit == 0 || frames <= limit)
    {
        return 1;
    }
    const std::size_t even = (frames + limit - 1) / limit;
    if (limit == 1 || keptOf(frames, even, last) <= limit)
    {
        return even;
    }
    return (frames - 1 + limit - 2) / (limit - 1);
}

double fallTime(const Scene& scene, const MeshReport& mesh)
{
    const double height = upVector(scene.object.up).dot(mesh.box.sizes());
    return std::sqrt(2 * height / gravityInMeshUnits(scene));
}

FrameTiming frameTiming(const Scene& scene, const MeshReport& mesh, double seconds, bool falls)
{
    const FrameSettings& frames = scene.frames;
    FrameTiming timing;
    const double slowest = kSlowestFall / fallTime(scene, mesh);
    timing.slowMotion = slowest;
    if (seconds > 0)
    {
        // The first frame shows the start and the last one the end.
        const double wished = frames.duration.value_or(kUsualDuration) - 1 / frames.fps;
        const double ofRun = falls ? wished - std::min(kDrawnFall, wished / 4) : wished;
        timing.slowMotion = std::max(ofRun, 1 / frames.fps) / seconds;
        if (!frames.duration && !falls)
        {
            timing.slowMotion = std::min(timing.slowMotion, slowest);
        }
        timing.lag = falls ? (wished - ofRun) / timing.slowMotion : 0;
    }
    if (frames.slowMotion)
    {
        timing.slowMotion = *frames.slowMotion;
        timing.lag = falls ? kDrawnFall / timing.slowMotion : 0;
    }
    timing.interval = 1 / (frames.fps * timing.slowMotion);
    return timing;
}

FrameSelection framesToDraw(const Scene& scene)
{
    const auto selection = FrameSelection::parse(scene.frames.selection).value();
    return scene.frames.limit == 1 && selection.hasLast() ? FrameSelection::parse("last").value()
                                                          : selection;
}

std::size_t heldFrames(const Scene& scene)
{
    return framesIn(scene.frames.hold, scene);
}

std::size_t turnFrames(const Scene& scene, double path)
{
    return framesIn(path > 0 ? path : scene.camera.turntable.value_or(0), scene);
}

std::size_t turnOfLast(const Scene& scene, double path)
{
    const auto selection = FrameSelection::parse(scene.frames.selection);
    return selection && selection->isLastOnly() ? turnFrames(scene, path) : 0;
}

FramePlan planFrames(const Scene& scene, const MeshReport& mesh, const RunLength& length,
                     double path)
{
    FramePlan plan;
    const auto selection = FrameSelection::parse(scene.frames.selection);
    if (!scene.frames.enabled || !selection)
    {
        return plan;
    }
    plan.timing = frameTiming(scene, mesh, length.seconds, !length.landings.empty());
    plan.held = scene.frames.hold > 0 ? heldFrames(scene) : turnOfLast(scene, path);
    std::size_t selected = 0;
    if (selection->isLastOnly() || scene.frames.limit == 1)
    {
        selected = std::max<std::size_t>(1, plan.held);
    }
    else
    {
        const double shown = (length.seconds + plan.timing.lag) / plan.timing.interval;
        plan.all = static_cast<std::size_t>(std::min(std::floor(shown + 1e-6) + 1, kMaxFrames));
        selected = selection->hasLast()
                       ? selection->countOf(plan.all) + plan.held
                       : selection->countOf(plan.all + std::max<std::size_t>(plan.held, 1));
    }
    // The end of the run may discard something, which takes one picture more to show.
    const double most = static_cast<double>(selected + (selection->hasLast() ? 1 : 0)) *
                        (length.exact ? 1 : kMoreThanModel);
    plan.stride = strideFor(static_cast<std::size_t>(std::ceil(most)), scene.frames.limit,
                            selection->hasLast());
    plan.kept = scene.frames.limit == 1 ? std::min<std::size_t>(1, selected)
                                        : keptOf(selected, plan.stride, selection->hasLast());
    plan.seconds = static_cast<double>(selected) / scene.frames.fps;
    plan.bytes =
        static_cast<double>(plan.kept) * kBytesPerPixel * scene.size.width * scene.size.height;
    return plan;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "run/frame_timing.hpp"

#include "scene/frame_selection.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kFallInVideo = 1.5; // [s]
// By runs of the four objects with their default settings: from its appearance to its rest a set
// takes about so many falls through the object and so many sqrt(r/g).
constexpr double kFallsPerSet = 0.5;
constexpr double kRadiusTimesPerSet = 20;
// What a picture takes as a PNG: the mean over runs of torus and human at 1280x720.
constexpr double kBytesPerPixel = 0.33;
// Spheres in a group when the scene leaves that open.
constexpr double kGroup = 10;

} // namespace

double fallTime(const Scene& scene, const MeshReport& mesh)
{
    const double height = upVector(scene.object.up).dot(mesh.box.sizes());
    return std::sqrt(2 * height / gravityInMeshUnits(scene));
}

FrameTiming frameTiming(const Scene& scene, const MeshReport& mesh)
{
    FrameTiming timing;
    timing.slowMotion = scene.frames.slowMotion.value_or(kFallInVideo / fallTime(scene, mesh));
    timing.interval = 1 / (scene.frames.fps * timing.slowMotion);
    return timing;
}

FrameEstimate estimateFrames(const Scene& scene, const MeshReport& mesh, std::size_t spheres,
                             double radius)
{
    FrameEstimate estimate;
    if (!scene.frames.enabled)
    {
        return estimate;
    }
    const double sets =
        std::ceil(static_cast<double>(spheres) / (std::max(kGroup, 1.0 * scene.spheres.groupSize) *
                                                  static_cast<double>(scene.spheres.groupsPerSet)));
    const double secondsPerSet = kFallsPerSet * fallTime(scene, mesh) +
                                 kRadiusTimesPerSet * std::sqrt(radius / gravityInMeshUnits(scene));
    const double frames = sets * secondsPerSet / frameTiming(scene, mesh).interval + 2;
    // Thinning halves the number until it is within the limit.
    double kept = frames;
    while (scene.frames.limit > 1 && kept > static_cast<double>(scene.frames.limit))
    {
        kept /= 2;
    }
    estimate.frames = static_cast<std::size_t>(
        scene.frames.limit == 1 ? 1.0 : std::min(kept, 9e15)); // 9e15: exact and in range
    if (const auto selection = FrameSelection::parse(scene.frames.selection))
    {
        estimate.frames = selection->countOf(estimate.frames);
    }
    estimate.bytes = static_cast<double>(estimate.frames) * kBytesPerPixel * scene.size.width *
                     scene.size.height;
    return estimate;
}

} // namespace frostfill

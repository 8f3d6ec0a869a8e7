// SPDX-License-Identifier: MIT
#include "run/verdict.hpp"

#include <frostfill/render_run.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr const char* kBlank = "the pictures are blank: the camera does not see the object";
constexpr const char* kLookAtMesh = "`frostfill mesh` tells whether the mesh crosses itself";

std::string spheres(std::size_t count)
{
    return fmt::format("{} sphere{}", count, count == 1 ? "" : "s");
}

std::string describe(const StraySphere& stray)
{
    const char* what = "was outside the object";
    const char* help = kLookAtMesh;
    if (stray.kind == StrayKind::tooFast)
    {
        what = "was faster than any fall explains";
        help = "try a smaller --dt or a lower --restitution";
    }
    if (stray.kind == StrayKind::notFinite)
    {
        what = "had a position or velocity that is not a number";
        help = "try a smaller --dt";
    }
    return fmt::format(
        "the run was stopped because sphere {} {}, at ({:g} {:g} {:g}) after {:g} s; "
        "{}",
        stray.sphere, what, stray.centre.x(), stray.centre.y(), stray.centre.z(), stray.time, help);
}

std::optional<std::string> findFaultOfFast(const FillResult& result, double restitution)
{
    const QualityReport& quality = result.quality;
    if (quality.settling && !quality.settling->settled)
    {
        return fmt::format("the spheres had not settled together when they were frozen: {:.2g} of "
                           "its weight is missing on one, and two overlap by {:.2g} of a radius; "
                           "try another --radius, more --friction, or --rest each",
                           quality.settling->missing, quality.maxOverlap);
    }
    if (quality.maxOverlap > kFaultyOverlap)
    {
        return fmt::format("two spheres overlap by {:.2g} of a radius; try a smaller --dt or more "
                           "--sweeps",
                           quality.maxOverlap);
    }
    if (quality.maxWallOverlap > kFaultyOverlap)
    {
        return fmt::format("a sphere is {:.2g} of its radius deep in a wall; {}",
                           quality.maxWallOverlap, kLookAtMesh);
    }
    const double most = std::max(1.0, kFaultyHanging * static_cast<double>(result.spheres));
    // Without any loss of speed only the time limit ends a run.
    if (static_cast<double>(quality.unsupported) > most && restitution < 1)
    {
        return fmt::format("{} of {} are at rest without support; try --motion descend, a lower "
                           "--restitution or a longer --set-time-limit",
                           spheres(quality.unsupported), result.spheres);
    }
    return std::nullopt;
}

} // namespace

std::optional<std::string> findFault(const Scene& scene, const FillResult& result,
                                     bool blankPictures)
{
    const QualityReport& quality = result.quality;
    if (result.stray)
    {
        return describe(*result.stray);
    }
    if (quality.notFinite > 0)
    {
        return fmt::format("{} ended at positions that are not numbers; try a smaller --dt",
                           spheres(quality.notFinite));
    }
    if (result.overfull)
    {
        return fmt::format(
            "the run was stopped after {}, which take more than the object's volume: "
            "they overlap or have left it; try a smaller --dt, or preset fast",
            spheres(result.spheres));
    }
    if (quality.centresOutside > 0)
    {
        return fmt::format("{} ended outside the object; {}", spheres(quality.centresOutside),
                           scene.preset == Preset::paper ? "try a smaller --dt, or preset fast"
                                                         : kLookAtMesh);
    }
    if (scene.preset == Preset::fast && !result.stopped)
    {
        if (auto fault = findFaultOfFast(result, scene.motion.restitution))
        {
            return fault;
        }
    }
    if (blankPictures)
    {
        return kBlank;
    }
    return std::nullopt;
}

std::optional<Error> failureOf(const FillResult& result)
{
    const std::string directory = result.directory.string();
    if (result.failure)
    {
        return Error(ErrorCode::postcondition,
                     fmt::format("{}; the files are in {}", *result.failure, directory));
    }
    if (result.noFrames)
    {
        return Error(ErrorCode::usage,
                     fmt::format("{}; the other files are in {}", *result.noFrames, directory));
    }
    if (result.videoFailure)
    {
        return Error(ErrorCode::writeFailed,
                     fmt::format("{}; the frames are in {}", *result.videoFailure, directory));
    }
    return std::nullopt;
}

std::optional<Error> failureOf(const RenderResult& result)
{
    const std::string directory = result.directory.string();
    if (result.blank)
    {
        return Error(ErrorCode::postcondition,
                     fmt::format("{}; they are in {}", kBlank, directory));
    }
    if (result.videoFailure)
    {
        return Error(ErrorCode::writeFailed,
                     fmt::format("{}; the frames are in {}", *result.videoFailure, directory));
    }
    return std::nullopt;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "run/run_files.hpp"

#include <frostfill/render_run.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr const char* kBlank = "the pictures are blank: the camera does not see the object; check "
                               "camera.target, camera.distance and --azimuth";
constexpr const char* kLookAtMesh = "`frostfill mesh` tells whether the mesh crosses itself";

std::string spheres(std::size_t count)
{
    return fmt::format("{} sphere{}", count, count == 1 ? "" : "s");
}

/// What may help where spheres have left the object.
const char* helpInside(const Scene& scene)
{
    return scene.preset == Preset::paper ? "try a smaller motion.dt, or preset fast" : kLookAtMesh;
}

std::string describe(const StraySphere& stray)
{
    const char* what = "was outside the object";
    const char* help = kLookAtMesh;
    if (stray.kind == StrayKind::tooFast)
    {
        what = "was over 10 times as fast as a fall through the object explains";
        help = "try a smaller motion.dt or a lower motion.restitution";
    }
    if (stray.kind == StrayKind::notFinite)
    {
        what = "had a position or velocity that is not finite";
        help = "try a smaller motion.dt";
    }
    return fmt::format(
        "the run was stopped because sphere {} {}, at ({:g} {:g} {:g}) after {:g} s; "
        "{}",
        stray.sphere, what, stray.centre.x(), stray.centre.y(), stray.centre.z(), stray.time, help);
}

/// What has not settled, with its value and its limit.
std::string unrestText(const QualityReport& quality)
{
    const SettlingReport& settling = *quality.settling;
    if (settling.overlap > SettlingReport::kOverlap)
    {
        return fmt::format("a sphere overlaps {} by {:.2g} of a radius, where {:g} is allowed",
                           quality.maxWallOverlap > quality.maxOverlap ? "a wall" : "another",
                           settling.overlap, SettlingReport::kOverlap);
    }
    if (settling.missing > SettlingReport::kMissing)
    {
        return fmt::format("forces miss {:.2g} of a sphere's weight, where {:g} is allowed",
                           settling.missing, SettlingReport::kMissing);
    }
    return fmt::format("forces miss more than {:g} of the weight of {}, where {} may be so",
                       SettlingReport::kMissingOnMost, spheres(settling.moving), settling.mayMove);
}

std::optional<std::string> findFaultOfFraction(const Scene& scene, const SettlingReport& settling)
{
    const RestSettings& rest = scene.rest;
    if (!rest.fraction || rest.fraction == RestSettings::kLoosest ||
        rest.fraction == RestSettings::kDensest)
    {
        return std::nullopt;
    }
    if (!settling.fraction)
    {
        return "the packing fraction (--fraction) cannot be measured: too little of the pile is 4 "
               "radii away from walls and from its top; fill in more spheres, or smaller ones";
    }
    const double missing = *rest.fraction - *settling.fraction;
    if (std::abs(missing) <= kFaultyFraction)
    {
        return std::nullopt;
    }
    const std::string help =
        missing > 0 ? "it flows no denser: ask for less"
        : scene.motion.mode != Motion::granular
            ? "it came in denser, and nothing loosens it: try --motion granular, or ask for more"
            : fmt::format("nothing loosens this pile: ask for more, or try another --seed{}",
                          rest.friction < 1 ? " or more --friction" : "");
    return fmt::format("the bulk packs to {:.4f}, where {:g} is asked to within {:g}; {}",
                       *settling.fraction, *rest.fraction, kFaultyFraction, help);
}

std::optional<std::string> findFaultOfFast(const Scene& scene, const FillResult& result)
{
    const QualityReport& quality = result.quality;
    if (quality.settling && !quality.settling->settled)
    {
        const RestSettings& rest = scene.rest;
        return fmt::format("the spheres had not settled together when they were frozen: {}; try "
                           "{}, another --radius, or --rest each",
                           unrestText(quality),
                           rest.friction == 0          ? "--friction 0.1"
                           : rest.rollingFriction == 0 ? "--set rest.rolling_friction=0.05"
                                                       : "more --friction");
    }
    if (const auto fault =
            quality.settling ? findFaultOfFraction(scene, *quality.settling) : std::nullopt)
    {
        return fault;
    }
    if (quality.maxOverlap > kFaultyOverlap)
    {
        return fmt::format("two spheres overlap by {:.2g} of a radius, where {:g} is allowed; try "
                           "a smaller motion.dt or more motion.sweeps",
                           quality.maxOverlap, kFaultyOverlap);
    }
    if (quality.maxWallOverlap > kFaultyOverlap)
    {
        return fmt::format("a sphere is {:.2g} of its radius deep in a wall, where {:g} is "
                           "allowed; {}",
                           quality.maxWallOverlap, kFaultyOverlap, kLookAtMesh);
    }
    const double most =
        std::floor(std::max(1.0, kFaultyHanging * static_cast<double>(result.spheres)));
    // Without any loss of speed only the time limit ends a run.
    if (static_cast<double>(quality.unsupported) > most && scene.motion.restitution < 1)
    {
        return fmt::format("{} of {} are at rest without support, where {:g} may be; try {}",
                           spheres(quality.unsupported), result.spheres, most,
                           quality.settling ? "another --seed or --radius"
                           : scene.motion.mode == Motion::descend
                               ? "--rest joint"
                               : "--motion descend, a lower motion.restitution or a longer "
                                 "freezing.set_time_limit");
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
        return fmt::format("{} ended at positions that are not finite; try a smaller motion.dt",
                           spheres(quality.notFinite));
    }
    if (result.overfull)
    {
        return fmt::format("the run was stopped after {}, which take more than the object's "
                           "volume: they overlap or have left it; {}",
                           spheres(result.spheres), helpInside(scene));
    }
    if (quality.centresOutside > 0)
    {
        return fmt::format("{} ended outside the object; {}", spheres(quality.centresOutside),
                           helpInside(scene));
    }
    if (scene.preset == Preset::fast && !result.stopped)
    {
        if (auto fault = findFaultOfFast(scene, result))
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

// SPDX-License-Identifier: MIT
#include "app/fill_text.hpp"

#include "app/progress/message.hpp"
#include "app/text/result_text.hpp"
#include "bulk/bulk.hpp"

#include <fmt/format.h>

#include <string>

namespace frostfill
{
namespace
{

std::string bytesText(double bytes)
{
    return bytes < 1e6 ? fmt::format("{:.0f} kB", bytes / 1e3)
                       : (bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                                      : fmt::format("{:.1f} GB", bytes / 1e9));
}

/// "radius 0.05", or "radii from 0.02 to 0.05".
std::string radiiText(double smallest, double largest)
{
    return smallest == largest ? fmt::format("radius {:.5g}", largest)
                               : fmt::format("radii from {:.5g} to {:.5g}", smallest, largest);
}

/// ": 20 s at 30 a second, 1.4 times slower than life, ..."; nothing for a still.
std::string playbackText(const Scene& scene, const FillPlan& plan)
{
    if (plan.videoSeconds <= 0 || plan.frames < 2 || plan.slowMotion <= 0)
    {
        return "";
    }
    const bool slow = plan.slowMotion >= 1;
    // Without dynamics there is no life to compare with.
    const std::string speed =
        scene.preset == Preset::fast && scene.motion.mode == Motion::descend
            ? ""
            : fmt::format(", {:.3g} times {} than life",
                          slow ? plan.slowMotion : 1 / plan.slowMotion, slow ? "slower" : "faster");
    return fmt::format(
        ": {:.3g} s at {:.3g} a second{}{}", plan.videoSeconds, plan.pictureRate, speed,
        plan.fallsLeftOut ? "" : fmt::format(", a fall takes {:.2g} s", plan.fallSeconds));
}

/// What to give for --radius instead: all radii smaller by one factor.
std::string radiusAdvice(const SphereSettings& given, const FillResult& result)
{
    const double factor = *result.radiusThatFits / result.largestRadius;
    if (given.sizes.curve || (given.radius && !given.radius->file.empty()))
    {
        return fmt::format("take radii {:.3g} times as large", factor);
    }
    const double smallest = factor * result.smallestRadius;
    const double largest = factor * result.largestRadius;
    return smallest == largest ? fmt::format("try --radius {:.3g}", largest)
                               : fmt::format("try --radius {:.3g}..{:.3g}", smallest, largest);
}

/// How near the sizes are to what was asked for.
std::string sizesText(const Scene& scene, const FillResult& result)
{
    if (!result.sizes)
    {
        return "";
    }
    const std::optional<double>& within = scene.spheres.sizes.within;
    const bool isKept = !within || result.sizes->deviation <= *within;
    return fmt::format("sizes are off by at most {:.2g} % of the mass, at the radius {:.4g}{}\n",
                       100 * result.sizes->deviation, result.sizes->at,
                       isKept ? ""
                              : fmt::format(", more than {:.2g} %: there are too few spheres, or "
                                            "the largest had no place",
                                            100 * *within));
}

/// What would fill an object that the count leaves partly empty.
std::string fillingText(const Scene& scene, const FillResult& result)
{
    if (result.full || result.inletsReached || result.stopped || scene.spheres.untilFull ||
        result.fitting <= result.spheres)
    {
        return "";
    }
    return fmt::format("there is room left; about {} spheres fill the object: add "
                       "--set spheres.until_full=true\n",
                       result.fitting);
}

std::string fractionText(double asked, double reached)
{
    const bool isEnd = asked == RestSettings::kLoosest || asked == RestSettings::kDensest;
    return fmt::format("the bulk packs to {:.4f}, {} ({})\n", reached,
                       !isEnd                            ? fmt::format("where {:g} is asked", asked)
                       : asked == RestSettings::kLoosest ? "as loosely as it gets"
                                                         : "as densely as it gets",
                       kBulkInWords);
}

} // namespace

void printPlan(const FillRequest& request, const FillPlan& plan)
{
    for (const std::string& repair : plan.repairs)
    {
        say(fmt::format("repaired: {}\n", repair));
    }
    for (const std::string& hint : plan.hints)
    {
        say(hint + "\n");
    }
    say(fmt::format("{}: {} triangles, about {} spheres of {}, time step {:.3g} s\n",
                    request.scene.name, plan.triangles, plan.spheres,
                    radiiText(plan.smallestRadius, plan.largestRadius), plan.timeStep));
    if (plan.crossedTriangles > 0)
    {
        const Eigen::Vector3d& p = plan.firstCrossing;
        say(fmt::format(
            "the mesh crosses itself: {} triangles meet others, the first near {:.6g} "
            "{:.6g} {:.6g}{}\n",
            plan.crossedTriangles, p.x(), p.y(), p.z(),
            request.scene.object.load.unite
                ? ""
                : "; walls inside the object stay as obstacles, which --set object.unite=true "
                  "removes"));
    }
    say(reachText(plan.reach, plan.smallestRadius, plan.volume));
    if (request.scene.frames.enabled)
    {
        say(fmt::format("expecting about {} of {}x{}, {}{}\n", counted(plan.frames, "frame"),
                        request.scene.size.width, request.scene.size.height,
                        bytesText(plan.frameBytes), playbackText(request.scene, plan)));
    }
    if (plan.fallsLeftOut)
    {
        say("there are too many spheres to draw the falls that --motion leaves out: they appear "
            "where they land\n");
    }
}

void printResult(const Scene& scene, const FillResult& result)
{
    fmt::print("{}", setTableText(result));
    if (result.stopped)
    {
        // How many fill an object is known roughly, and may be less than are there.
        const bool isCounted = scene.spheres.count && !scene.spheres.untilFull;
        fmt::print("stopped early, with {} {}spheres\n", result.spheres,
                   isCounted ? fmt::format("of {} ", *scene.spheres.count) : "");
    }
    else if (result.radiusThatFits)
    {
        fmt::print(
            "full before the count: {} of {} spheres are in, and no other sphere of {} fits; {}\n",
            result.spheres, *scene.spheres.count,
            radiiText(result.smallestRadius, result.largestRadius),
            radiusAdvice(scene.spheres, result));
    }
    else if (result.full)
    {
        const bool isBound = result.sizes && scene.spheres.sizes.within;
        fmt::print("full: after {} spheres, no other one fits{}\n", result.spheres,
                   isBound ? " with which the size curve is kept" : "");
    }
    else if (result.inletsReached)
    {
        fmt::print("the heap has reached the inlets: after {} spheres, no other one comes in\n",
                   result.spheres);
    }
    if (const auto& settling = result.quality.settling; settling && settling->settled)
    {
        fmt::print("all spheres rest together: at most {:.2g} of its weight is missing on any\n",
                   settling->missing);
        if (settling->fraction)
        {
            fmt::print("{}", fractionText(*scene.rest.fraction, *settling->fraction));
        }
    }
    for (const HeapReport& heap : result.quality.heaps)
    {
        if (heap.slope && scene.motion.mode == Motion::granular)
        {
            fmt::print("a heap of {} spheres lies at {:.1f} degrees\n", heap.spheres, *heap.slope);
        }
    }
    fmt::print("{}{}", sizesText(scene, result), fillingText(scene, result));
    if (result.skippedFrames > 0)
    {
        fmt::print("{} of the {} pictures were there already\n", result.skippedFrames,
                   result.frames);
    }
    fmt::print("{} spheres of {} take {:.1f} % of the volume; {}; {:.1f} s; "
               "results in {}\n",
               result.spheres, radiiText(result.smallestRadius, result.largestRadius),
               100 * result.quality.sphereVolume / result.quality.meshVolume,
               counted(result.frames, "frame"), result.wallSeconds, result.directory.string());
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/world/fitting_radius.hpp"

#include "scene/thick_parts.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Places of the surface that are looked at. Larger: time. Smaller: thin parts are missed.
constexpr std::size_t kSamples = 1000;
/// Of what did fit, what is counted on with another radius. [1] Larger: it may fall short again.
constexpr double kShareOfFitted = 0.95;

/// In the run's units.
ThickParts thickParts(const World& world)
{
    MeshReport report = world.report;
    report.volume /= std::pow(world.frame.length, 3);
    return {report, world.surface.mesh(), world.surface.tree(), kSamples};
}

double radiusThatFits(const World& world, const ThickParts& parts, std::size_t count)
{
    const RelativeRadii radii{world.radii.meanPower(1), world.radii.meanPower(3)};
    double share = kShareOfEstimate;
    const double expected = parts.count(1, radii);
    if (world.clock.full && expected > 0)
    {
        const auto fitted = static_cast<double>(std::max<std::size_t>(1, world.spheres.size()));
        share = std::min(share, kShareOfFitted * fitted / expected);
    }
    return parts.radius(static_cast<double>(count) / share, radii) * world.frame.length;
}

} // namespace

double radiusThatFits(const World& world, std::size_t count)
{
    return radiusThatFits(world, thickParts(world), count);
}

void refuseTooLarge(const World& world)
{
    const ThickParts parts = thickParts(world);
    const bool isCurve = world.radii.curve().has_value(); // whose largest have to fit
    std::string help = isCurve ? "choose smaller --sizes" : "choose a smaller --radius";
    if (world.targetCount > 0 && !isCurve)
    {
        help = fmt::format("{} of radius {:.3g} should fit", world.targetCount,
                           radiusThatFits(world, parts, world.targetCount));
    }
    throw Error(ErrorCode::badData,
                fmt::format("no sphere of radius {:g} fits into {}: where it is thickest there is "
                            "room for a radius of {:.3g}; {}",
                            world.frame.length * (isCurve ? 1 : world.radii.smallest()),
                            world.scene.object.mesh, world.frame.length * parts.largest(), help));
}

} // namespace frostfill

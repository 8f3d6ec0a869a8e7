// SPDX-License-Identifier: MIT
#include "simulation/release/inlets.hpp"

#include "base/random.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/release/tolerances.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

void refuse(const Inlet& inlet, const char* why)
{
    throw Error(ErrorCode::usage,
                fmt::format("the inlet at ({:g} {:g} {:g}) with the radius {:g} {}",
                            inlet.centre.x(), inlet.centre.y(), inlet.centre.z(), inlet.radius,
                            why));
}

} // namespace

Inlets::Inlets(const World& world) : world_(world)
{
    double area = 0;
    for (const Inlet& inlet : world.scene.spheres.inlets)
    {
        const Opening opening = {world.frame.toRun(inlet.centre), inlet.radius / world.frame.length,
                                 area += inlet.radius * inlet.radius};
        if (!world.inside.contains(opening.centre))
        {
            refuse(inlet, "is not inside the object: give a centre inside, such as just below the "
                          "top");
        }
        if (opening.radius < world.radii.largest())
        {
            refuse(inlet, "is narrower than the largest sphere: give a larger radius");
        }
        openings_.push_back(opening);
    }
    for (Opening& opening : openings_)
    {
        opening.share /= area;
    }
}

std::optional<PlacedSphere> Inlets::next(const ReleaseQuery& query)
{
    if (!radius_)
    {
        radius_ = world_.radii.draw(uniformRandom(world_.scene.seed, ++radii_, kRadiusDraw),
                                    world_.radii.largest());
    }
    const auto found = place(*radius_, query);
    if (!found)
    {
        return std::nullopt;
    }
    const PlacedSphere sphere = {*found, *radius_};
    radius_.reset();
    return sphere;
}

std::optional<Eigen::Vector3d> Inlets::place(double radius, const ReleaseQuery& query)
{
    for (int misses = 0; misses < kMaxMissesInInlets; ++misses)
    {
        Eigen::Vector3d p = draw(radius);
        Footprint unused;
        if (world_.inside.contains(p) && depenetrate(world_, p, radius, kOffInInlet * radius) &&
            (!query.prepare || query.prepare(p, radius, unused)) && query.suits(p, radius))
        {
            return p;
        }
    }
    return std::nullopt;
}

bool Inlets::any()
{
    return place(world_.radii.smallest(),
                 {.suits = [](const Eigen::Vector3d&, double) { return true; }})
        .has_value();
}

// Evenly over the openings.
Eigen::Vector3d Inlets::draw(double radius)
{
    const auto random = [&, number = ++draws_](std::uint64_t k)
    { return uniformRandom(world_.scene.seed, number, k); };
    const double choice = random(0);
    const auto among = std::find_if(openings_.begin(), openings_.end() - 1,
                                    [&](const Opening& one) { return choice < one.share; });
    const double arm = (among->radius - radius) * std::sqrt(random(1));
    const double angle = 2 * std::numbers::pi * random(2);
    return among->centre + arm * Eigen::Vector3d(std::cos(angle), 0, std::sin(angle));
}

} // namespace frostfill

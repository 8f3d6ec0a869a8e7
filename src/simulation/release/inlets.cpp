// SPDX-License-Identifier: MIT
#include "simulation/release/inlets.hpp"

#include "base/random.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/release/release_rule.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

[[noreturn]] void refuse(const Inlet& inlet, const char* why)
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
            refuse(inlet, "is not inside the object: give a centre inside, more than a sphere's "
                          "radius below the top");
        }
        if (opening.radius < world.radii.largest())
        {
            refuse(inlet, "is narrower than the largest sphere: give a larger radius");
        }
        if (world.spheres.resting().size() == 0 && !letsIn(opening))
        {
            refuse(inlet, "leaves no room for a sphere: put it more than a sphere's radius away "
                          "from walls");
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
        const std::uint64_t seed = world_.scene.seed;
        ++radii_;
        radius_ = world_.radii.draw(world_.radii.curve() ? evenRandom(seed, radii_)
                                                         : uniformRandom(seed, radii_, kRadiusDraw),
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
        Eigen::AlignedBox3d unused;
        if (isClear(p, radius) && (!query.prepare || query.prepare(p, radius, unused)) &&
            query.suits(p, radius))
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

// An opening with a probability in proportion to its area.
Eigen::Vector3d Inlets::draw(double radius)
{
    const double choice = uniformRandom(world_.scene.seed, ++draws_, 0);
    const auto among = std::find_if(openings_.begin(), openings_.end() - 1,
                                    [&](const Opening& one) { return choice < one.share; });
    return placeIn(*among, radius, draws_);
}

// Evenly over the opening.
Eigen::Vector3d Inlets::placeIn(const Opening& opening, double radius, std::uint64_t number) const
{
    const auto random = [&](std::uint64_t k)
    { return uniformRandom(world_.scene.seed, number, k); };
    const double arm = (opening.radius - radius) * std::sqrt(random(1));
    const double angle = 2 * std::numbers::pi * random(2);
    return opening.centre + arm * Eigen::Vector3d(std::cos(angle), 0, std::sin(angle));
}

bool Inlets::isClear(Eigen::Vector3d& place, double radius) const
{
    return world_.inside.contains(place) &&
           depenetrate(world_, place, radius, kOffInInlet * radius);
}

// Of the largest spheres.
bool Inlets::letsIn(const Opening& opening) const
{
    const double radius = world_.radii.largest();
    for (std::uint64_t number = 0; number < kMaxMissesInInlets; ++number)
    {
        Eigen::Vector3d place = placeIn(opening, radius, number);
        if (isClear(place, radius))
        {
            return true;
        }
    }
    return false;
}

} // namespace frostfill

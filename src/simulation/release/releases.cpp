// SPDX-License-Identifier: MIT
#include "simulation/release/releases.hpp"

#include "base/random.hpp"
#include "simulation/release/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// The largest radius of each class, ascending: the smallest of all, then by a constant ratio.
std::vector<double> classLimits(const RadiusDistribution& radii)
{
    std::vector<double> limits = radii.distinct(kMaxClasses);
    if (!limits.empty())
    {
        return limits;
    }
    const double octaves = std::log(radii.largest() / radii.smallest());
    const auto steps = static_cast<std::size_t>(std::clamp(
        std::ceil(octaves / std::log(kWidestClass)), 1.0, static_cast<double>(kMaxClasses - 1)));
    limits.push_back(radii.smallest());
    for (std::size_t k = 1; k < steps; ++k)
    {
        const double share = static_cast<double>(k) / static_cast<double>(steps);
        limits.push_back(radii.smallest() * std::exp(share * octaves));
    }
    limits.push_back(radii.largest());
    return limits;
}

} // namespace

Releases::Releases(const World& world, double band, Threads& threads) : world_(world)
{
    for (const double limit : classLimits(world.radii))
    {
        classes_.push_back({limit, ReleaseSites(world, limit, band, threads)});
    }
}

std::optional<PlacedSphere> Releases::next(const ReleaseQuery& query)
{
    while (!classes_.empty())
    {
        if (!drawn_)
        {
            draw();
        }
        const double radius = *drawn_;
        if (const auto found = place(radius, query))
        {
            drawn_.reset();
            return PlacedSphere{*found, radius};
        }
        if (classes_.size() == 1 || classes_[lastClass_].sites.any())
        {
            return std::nullopt;
        }
        dropClasses(std::max<std::size_t>(1, lastClass_));
    }
    return std::nullopt;
}

std::optional<Eigen::Vector3d> Releases::place(double radius, const ReleaseQuery& query)
{
    if (radius > classes_.back().largest)
    {
        return std::nullopt;
    }
    lastClass_ = classOf(radius);
    const auto prepare = [&](const Eigen::Vector3d& place)
    { return query.prepare ? query.prepare(place, radius) : place; };
    const auto suits = [&](const Eigen::Vector3d& place) { return query.suits(place, radius); };
    // A draw that is known ahead is so for one radius.
    return classes_[lastClass_].sites.find(prepare, suits, query.ahead && world_.radii.equal(),
                                           query.givesUp);
}

void Releases::close(const Eigen::Vector3d& centre, double radius)
{
    for (Class& one : classes_)
    {
        one.sites.close(centre, radius);
    }
}

void Releases::draw()
{
    drawn_ = world_.radii.draw(uniformRandom(world_.scene.seed, ++draws_, kRadiusDraw),
                               classes_.back().largest);
}

void Releases::dropClasses(std::size_t from)
{
    while (classes_.size() > from)
    {
        classes_.pop_back();
    }
    drawn_.reset();
}

std::size_t Releases::classOf(double radius) const
{
    const auto found = std::partition_point(classes_.begin(), classes_.end(),
                                            [&](const Class& one) { return one.largest < radius; });
    return static_cast<std::size_t>(found - classes_.begin());
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/release/releases.hpp"

#include "base/random.hpp"
#include "simulation/release/size_draws.hpp"
#include "simulation/release/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

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

Releases::Releases(const World& world, double band, Threads& threads)
    : world_(world), threads_(threads)
{
    for (const double limit : classLimits(world.radii))
    {
        // Sites for small spheres are many. While the object fills from below coarse ones will do.
        const double coarsest = world.radii.curve() && band >= 0 ? kCoarsestSites : 0;
        classes_.push_back({limit,
                            std::make_unique<ReleaseSites>(world, limit, band, threads, coarsest),
                            limit < coarsest});
    }
    if (world.radii.curve())
    {
        ledger_.emplace(*world.radii.curve());
        for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
        {
            ledger_->add(world.spheres.radius(id));
        }
        draws_ = world.spheres.size();
    }
}

// The radius is kept until it finds a place: else those with few places would be too few. Each
// round gives up a class, makes its sites finer for the only time, or is the last.
std::optional<PlacedSphere> Releases::next(const ReleaseQuery& query)
{
    while (drawn_ || drawRadius())
    {
        const double radius = *drawn_;
        const std::size_t ofClass = classOf(radius);
        Class& one = classes_[ofClass];
        if (const auto place = one.sites->find(radius, query, computingAhead(radius, query)))
        {
            drawn_.reset();
            if (ledger_)
            {
                ledger_->add(radius);
            }
            return PlacedSphere{*place, radius};
        }
        if (query.isStopped())
        {
            return std::nullopt;
        }
        if (findsMore(one))
        {
            continue;
        }
        if (ofClass == 0 || one.sites->any())
        {
            return std::nullopt;
        }
        dropClasses(ofClass);
        ranOut_ = true;
    }
    return std::nullopt;
}

// Whether the class has got finer sites, in which there is a place for now or later.
bool Releases::findsMore(Class& one)
{
    if (!one.isCoarse || one.sites->any())
    {
        return false;
    }
    one.isCoarse = false;
    one.sites = std::make_unique<ReleaseSites>(world_, one.largest, -1, threads_);
    one.sites->scatter(true);
    return true;
}

// Once sizes have run out, only those are drawn that a size curve can still bear. False when there
// is none: the curve cannot be kept any longer.
bool Releases::drawRadius()
{
    const std::optional<double>& within = world_.scene.spheres.sizes.within;
    const bool isBound = ledger_ && ranOut_ && within;
    const double most = isBound ? std::max(*within, ledger_->deviation()) : 0;
    for (int k = 0; k < kMaxDrawsOfCurve; ++k)
    {
        const double radius = radiusOfDraw(++draws_);
        if (!isBound || ledger_->deviationWith(radius) <= most)
        {
            drawn_ = radius;
            return true;
        }
    }
    return false;
}

std::optional<Eigen::Vector3d> Releases::place(double radius, const ReleaseQuery& query)
{
    if (radius > classes_.back().largest)
    {
        return std::nullopt; // its class is done with
    }
    return classes_[classOf(radius)].sites->find(radius, query, computingAhead(radius, query));
}

std::function<void()> Releases::computingAhead(double radius, const ReleaseQuery& query)
{
    if (query.ahead == 0 || threads_.concurrency() == 1)
    {
        return {};
    }
    return [this, radius, &query] { computeAhead(radius, query); };
}

// The radii that come next, if each finds a place at once.
void Releases::computeAhead(double radius, const ReleaseQuery& query)
{
    unknown_.clear();
    std::vector<std::uint64_t> expected(classes_.size(), 0);
    std::uint64_t number = draws_;
    for (std::size_t k = 0; k < query.ahead; ++k, radius = radiusOfDraw(++number))
    {
        const std::size_t ofClass = classOf(radius);
        ReleaseSites& sites = *classes_[ofClass].sites;
        Draw* draw = sites.expect(expected[ofClass]++, radius);
        if (draw == nullptr)
        {
            break;
        }
        if (!draw->isKnown)
        {
            unknown_.push_back({&sites, draw});
        }
    }
    threads_.forEachLarge(unknown_.size(), [&](std::size_t i)
                          { unknown_[i].sites->compute(*unknown_[i].draw, query); });
}

void Releases::close(const Eigen::Vector3d& centre, double radius)
{
    for (Class& one : classes_)
    {
        one.sites->close(centre, radius);
    }
}

double Releases::radiusOfDraw(std::uint64_t number) const
{
    const std::uint64_t seed = world_.scene.seed;
    const double share =
        ledger_ ? evenRandom(seed, number) : uniformRandom(seed, number, kRadiusDraw);
    return world_.radii.draw(share, classes_.back().largest);
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

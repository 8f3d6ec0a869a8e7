// SPDX-License-Identifier: MIT
#include "simulation/release/releases.hpp"

#include "base/random.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/release/inlets.hpp"
#include "simulation/release/release_rule.hpp"
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

GapReleases::GapReleases(const World& world, double band, Threads& threads)
    : world_(world), threads_(threads), band_(band)
{
    double below = 0;
    for (const double limit : classLimits(world.radii))
    {
        const double share = world.radii.curve()->cumulative(limit, SizeCurve::kNumber);
        if (share > below)
        {
            classes_.push_back({below, share, limit});
            below = share;
        }
    }
    std::reverse(classes_.begin(), classes_.end());
    for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
    {
        const auto smaller =
            std::find_if(classes_.begin() + 1, classes_.end(),
                         [&](const Class& one) { return one.largest < world.spheres.radius(id); });
        ++(smaller - 1)->placed;
        ++draws_;
    }
    all_ = static_cast<double>(world.targetCount);
    enter(0);
}

// Sites of classes that come later are not kept up to date, but found when their turn comes.
void GapReleases::enter(std::size_t index)
{
    current_ = index;
    drawn_.reset();
    sites_.reset();
    if (index == 1 && all_ == 0)
    {
        const Class& largest = classes_.front();
        all_ = static_cast<double>(largest.placed) / (largest.high - largest.low);
    }
    if (index < classes_.size())
    {
        sites_.emplace(world_, classes_[index].largest, index == 0 ? band_ : -1, threads_);
        sites_->scatter(index > 0);
    }
}

// Until full, the largest are as many as fit; and the smallest, if the curve need not be kept.
bool GapReleases::isComplete() const
{
    const bool isLast = current_ + 1 == classes_.size();
    if (all_ == 0 || (isLast && world_.targetCount == 0 && !world_.scene.spheres.sizes.within))
    {
        return false;
    }
    const Class& one = classes_[current_];
    // Down to its smallest: so that rounding adds up to no more than one sphere.
    std::size_t before = 0;
    for (std::size_t k = 0; k <= current_; ++k)
    {
        before += classes_[k].placed;
    }
    const double wanted = isLast ? all_ : all_ * (1 - one.low);
    return static_cast<double>(before) >= std::round(wanted) ||
           static_cast<double>(one.placed) >= std::ceil(all_ * (one.high - one.low));
}

std::optional<PlacedSphere> GapReleases::next(const ReleaseQuery& query)
{
    while (current_ < classes_.size())
    {
        if (isComplete())
        {
            enter(current_ + 1);
            continue;
        }
        if (!drawn_)
        {
            drawn_ = radiusOfDraw(++draws_);
        }
        const double radius = *drawn_;
        if (const auto place = sites_->find(radius, query))
        {
            ++classes_[current_].placed;
            drawn_.reset();
            return PlacedSphere{*place, radius};
        }
        if (query.isStopped() || sites_->any())
        {
            return std::nullopt; // it has not looked everywhere, or others run through a place
        }
        enter(current_ + 1);
    }
    return std::nullopt;
}

std::optional<Eigen::Vector3d> GapReleases::place(double radius, const ReleaseQuery& query)
{
    return ReleaseSites(world_, radius, -1, threads_).find(radius, query);
}

void GapReleases::close(const Eigen::Vector3d& centre, double radius)
{
    if (sites_)
    {
        sites_->close(centre, radius);
    }
}

double GapReleases::radiusOfDraw(std::uint64_t number) const
{
    const Class& one = classes_[current_];
    const double share = evenRandom(world_.scene.seed, number);
    return world_.radii.curve()->quantile(one.low + share * (one.high - one.low));
}

std::unique_ptr<ReleasePart> makeRelease(const World& world, double band, Threads& threads)
{
    std::unique_ptr<ReleasePart> release;
    if (!world.scene.spheres.inlets.empty())
    {
        release = std::make_unique<Inlets>(world);
    }
    else if (world.scene.spheres.sizes.fillGaps)
    {
        release = std::make_unique<GapReleases>(world, band, threads);
    }
    else
    {
        release = std::make_unique<Releases>(world, band, threads);
    }
    if (world.spheres.size() == 0 && !release->any())
    {
        refuseTooLarge(world);
    }
    return release;
}

std::size_t releaseAmong(const RunningSpheres& runners, SphereGrid& grid, std::size_t wanted,
                         ReleasePart& release, ReleaseQuery query, const StopRequest& stop,
                         const std::function<void(const PlacedSphere&)>& appear)
{
    query.stop = &stop;
    query.ahead = kDrawsAhead;
    query.givesUp = true; // when those that run have come to rest, every free place suits
    query.suits = [&grid](const Eigen::Vector3d& place, double radius)
    { return isClearOf(grid, place, radius); };
    gather(grid, runners);
    std::size_t found = 0;
    while (found < wanted && !stop.isAsked())
    {
        const auto next = release.next(query);
        if (!next)
        {
            break;
        }
        grid.insert(static_cast<std::uint32_t>(grid.size()), next->place, next->radius);
        appear(*next);
        ++found;
    }
    return found;
}

void endForWantOfPlaces(World& world, const ReleasePart& release)
{
    if (wantedOfSet(world, 1) == 0)
    {
        return;
    }
    (release.findsEveryPlace() ? world.clock.full : world.clock.inletsReached) = true;
}

} // namespace frostfill

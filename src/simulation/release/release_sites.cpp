// SPDX-License-Identifier: MIT
#include "simulation/release/release_sites.hpp"

#include "base/random.hpp"
#include "simulation/contact/contact.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

ReleaseSites::ReleaseSites(const World& world, double radius, double band, Threads& threads,
                           double coarsest)
    : world_(world), threads_(threads), radius_(radius),
      sites_(world.surface, world.inside, radius, threads, coarsest)
{
    if (band >= 0)
    {
        findCeilings(band);
    }
}

void ReleaseSites::findCeilings(double band)
{
    const auto height = [&](std::size_t site) { return sites_.height(site); };
    ceilings_ = sites_.highest();
    std::sort(ceilings_.begin(), ceilings_.end(),
              [&](std::uint32_t a, std::uint32_t b)
              { return std::pair(height(a), a) < std::pair(height(b), b); });
    const double inBand = band / sites_.cell();
    const auto isLow = [&](std::uint32_t site)
    {
        return static_cast<double>(height(site)) + inBand <
               static_cast<double>(height(ceilings_.back()));
    };
    const auto first = std::partition_point(ceilings_.begin(), ceilings_.end(), isLow);
    window_ = static_cast<std::size_t>(ceilings_.end() - first);
}

// Ceilings are few: whether something rests in one is looked up when it is drawn.
void ReleaseSites::close(const Eigen::Vector3d& centre, double radius)
{
    if (sweeping_)
    {
        sites_.close(centre, radius);
    }
    for (std::uint64_t number = draws_ + 1; number <= lastExpected_; ++number)
    {
        Draw& draw = batch_[number % kBatch];
        draw.isKnown = draw.isKnown && !draw.seen.contains(centre);
    }
}

std::optional<Eigen::Vector3d> ReleaseSites::find(double radius, const ReleaseQuery& query,
                                                  const std::function<void()>& computeAhead)
{
    for (const bool highOnly : {true, false})
    {
        highOnly_ = highOnly;
        for (int misses = 0; misses < kMaxMisses && !ceilings_.empty() && !query.isStopped();)
        {
            const Draw draw = nextDraw(radius, query, computeAhead);
            endDraw(draw);
            if (draw.stays && query.suits(draw.place, radius))
            {
                return draw.place;
            }
            misses += draw.stays ? 1 : 0; // else a ceiling goes, which ends by itself
        }
    }
    return ceilings_.empty() ? sweep(radius, query) : std::nullopt;
}

bool ReleaseSites::any()
{
    return find(radius_, {.suits = [](const Eigen::Vector3d&, double) { return true; }})
        .has_value();
}

std::size_t ReleaseSites::ceilingOf(std::uint64_t draw) const
{
    const double choice = uniformRandom(world_.scene.seed, draw, 0);
    const auto among = static_cast<double>(highOnly_ ? window_ : ceilings_.size());
    return ceilings_.size() - 1 - static_cast<std::size_t>(choice * among);
}

Draw* ReleaseSites::expect(std::uint64_t n, double radius)
{
    const std::uint64_t number = draws_ + 1 + n;
    if (ceilings_.empty() || number / kBatch != (draws_ + 1) / kBatch)
    {
        return nullptr;
    }
    batch_.resize(kBatch);
    Draw& draw = batch_[number % kBatch];
    const std::uint32_t site = ceilings_[ceilingOf(number)];
    if (!draw.is(number, site, radius))
    {
        draw = {.number = number, .site = site, .radius = radius};
    }
    lastExpected_ = std::max(lastExpected_, number);
    return &draw;
}

Draw ReleaseSites::nextDraw(double radius, const ReleaseQuery& query,
                            const std::function<void()>& computeAhead)
{
    if (!computeAhead)
    {
        const std::uint64_t number = draws_ + 1;
        Draw draw = {.number = number, .site = ceilings_[ceilingOf(number)], .radius = radius};
        compute(draw, query);
        return draw;
    }
    Draw& next = *expect(0, radius);
    if (!next.isKnown)
    {
        computeAhead();
    }
    next.isClear = next.isClear && sites_.isOpen(next.site); // an earlier draw may have closed it
    next.stays = next.stays && next.isClear;
    return next;
}

void ReleaseSites::endDraw(const Draw& draw)
{
    draws_ = draw.number;
    if (!draw.stays)
    {
        ended_.push_back(ceilingOf(draws_));
        if (!draw.isClear)
        {
            sites_.closeSite(draw.site);
        }
    }
    if ((draws_ + 1) % kBatch == 0)
    {
        removeEnded();
    }
}

// The next lower ceiling takes the place of an ended one in the window.
void ReleaseSites::removeEnded()
{
    std::sort(ended_.begin(), ended_.end(), std::greater<>());
    ended_.erase(std::unique(ended_.begin(), ended_.end()), ended_.end());
    for (const std::size_t index : ended_)
    {
        ceilings_[index] = ceilings_.back();
        ceilings_.pop_back();
    }
    ended_.clear();
    window_ = std::min(window_, ceilings_.size());
}

void ReleaseSites::compute(Draw& draw, const ReleaseQuery& query) const
{
    draw.seen.setEmpty();
    draw.isClear = false;
    addSeen(draw.seen, sites_.centre(draw.site), radius_);
    if (!isTaken(draw.site)) // else nothing is ever released there
    {
        computePlace(draw);
    }
    draw.stays =
        draw.isClear && (!query.prepare || query.prepare(draw.place, draw.radius, draw.seen));
    draw.isKnown = true;
}

// A clear place at a random point of the ceiling, or at its middle.
void ReleaseSites::computePlace(Draw& draw) const
{
    const Eigen::Vector3d middle = sites_.centre(draw.site);
    const auto findNear = [&](const Eigen::Vector3d& p, double within, Start start)
    {
        draw.place = p;
        addSeen(draw.seen, p, radius_ + within);
        return depenetrate(world_, draw.place, radius_, within, kMoves, start);
    };
    const std::uint64_t seed = world_.scene.seed;
    Eigen::Vector3d p = middle;
    // By at most half a cell along two axes.
    p.x() += sites_.cell() * (uniformRandom(seed, draw.number, 1) - 0.5);
    p.z() += sites_.cell() * (uniformRandom(seed, draw.number, 2) - 0.5);
    draw.isClear = findNear(p, radius_, startWithin(sites_.cell())) ||
                   findNear(middle, farthest(), startWithin(0));
}

// A site was opened inside, where walls are farther away than this.
Start ReleaseSites::startWithin(double way) const
{
    return way < sites_.depth() ? Start::inside : Start::anywhere;
}

// Whether the site was closed, or a sphere at rest leaves no place in its cell, as
// SiteLattice::close would find.
bool ReleaseSites::isTaken(std::size_t site) const
{
    if (!sites_.isOpen(site))
    {
        return true;
    }
    const Eigen::Vector3d centre = sites_.centre(site);
    bool taken = false;
    const SphereGrid& resting = world_.spheres.resting();
    resting.forEachNear(centre, radius_ + 1,
                        [&](std::uint32_t row)
                        {
                            const Ball& sphere = resting[row];
                            const double limit = sites_.closedWithin(sphere.radius);
                            taken = taken ||
                                    (limit > 0 &&
                                     (sphere.position() - centre).squaredNorm() <= limit * limit);
                        });
    return taken;
}

void ReleaseSites::startSweep()
{
    if (sweeping_)
    {
        return;
    }
    sweeping_ = true;
    const SphereGrid& resting = world_.spheres.resting();
    forEachBySlab(
        resting, resting.size(), threads_, [](std::uint32_t row) { return row; },
        [&](std::uint32_t row) { sites_.close(resting[row].position(), resting[row].radius); });
}

std::optional<Eigen::Vector3d> ReleaseSites::sweep(double radius, const ReleaseQuery& query)
{
    startSweep();
    sweep_ = sites_.nextOpen(sweep_);
    std::size_t first = sweep_;
    if (scattered_)
    {
        const double share = uniformRandom(world_.scene.seed, ++draws_, kGapDraw);
        first = SiteLattice::begin() +
                static_cast<std::size_t>(share *
                                         static_cast<double>(sites_.end() - SiteLattice::begin()));
    }
    const auto found = sweepFrom(first, radius, query);
    return found || first <= sweep_ ? found : sweepFrom(sweep_, radius, query);
}

// Open sites that turn out to have no place are closed.
std::optional<Eigen::Vector3d> ReleaseSites::sweepFrom(std::size_t site, double radius,
                                                       const ReleaseQuery& query)
{
    int misses = 0;
    for (site = sites_.nextOpen(site);
         site < sites_.end() && !query.isStopped() && !(query.givesUp && misses >= kMaxMisses);
         site = sites_.nextOpen(site + 1))
    {
        Eigen::Vector3d place = sites_.centre(site);
        Eigen::AlignedBox3d unused;
        if (!depenetrate(world_, place, radius_, farthest(), kMoves, startWithin(0)) ||
            (query.prepare && !query.prepare(place, radius, unused)))
        {
            sites_.closeSite(site);
        }
        else if (query.suits(place, radius))
        {
            return place;
        }
        else
        {
            ++misses;
        }
    }
    return std::nullopt;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
// Which ceiling of ReleaseSites is drawn, what a draw leads to, and draws that are found out ahead.
#include "base/random.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/release/release_sites.hpp"

namespace frostfill
{

std::size_t ReleaseSites::ceilingOfDraw(std::uint64_t number) const
{
    const double choice = uniformRandom(world_.scene.seed, number, 0);
    const auto among = static_cast<double>(highOnly_ ? window_ : ceilings_.size());
    return ceilings_.size() - 1 - static_cast<std::size_t>(choice * among);
}

// A draw that is known to end its ceiling decides which ceilings are drawn after it. Where ceilings
// are forgotten all the time, most are so because they are taken: that is found out here and now.
Draw* ReleaseSites::expectPlace(double radius)
{
    const bool forgetting = draws_ < lastForgotten_ + kForgets;
    const std::size_t most = forgetting ? kAheadWhileForgetting : kMostAhead;
    while (!ceilings_.empty() && expected_ + 1 < most)
    {
        const std::uint64_t number = draws_ + ++expected_;
        const std::size_t index = ceilingOfDraw(number);
        Draw& draw = ahead_.expect(key(number, radius));
        if (!draw.isLookedAt && forgetting)
        {
            lookAtSite(draw);
        }
        if (!draw.endsCeiling())
        {
            return &draw;
        }
        passed_.push_back({index, draw.key.site, window_});
        dropCeiling(index);
    }
    return nullptr;
}

void ReleaseSites::rewind()
{
    for (; !passed_.empty(); passed_.pop_back())
    {
        const auto& [index, site, window] = passed_.back();
        ceilings_.push_back(index < ceilings_.size() ? ceilings_[index] : site);
        ceilings_[index] = site;
        window_ = window;
    }
    expected_ = 0;
}

// A site was opened inside, where walls are farther away than this.
Start ReleaseSites::startWithin(double way) const
{
    return way < radius_ - sites_.halfDiagonal() ? Start::inside : Start::anywhere;
}

// Nothing is ever released from a site that is taken.
void ReleaseSites::lookAtSite(Draw& draw) const
{
    draw.isLookedAt = true;
    draw.place.reset();
    draw.seen.clear();
    draw.seen.addBall(sites_.centre(draw.key.site), radius_);
    draw.isKnown = isTaken(draw.key.site);
}

// A clear place at a random point of the ceiling, or at its middle.
void ReleaseSites::findPlace(Draw& draw) const
{
    const Eigen::Vector3d middle = sites_.centre(draw.key.site);
    const auto findNear = [&](Eigen::Vector3d p, double within, Start start)
    {
        draw.seen.addBall(p, radius_ + within);
        if (depenetrate(world_, p, radius_, within, kMoves, start))
        {
            draw.place = p;
        }
    };
    const std::uint64_t seed = world_.scene.seed;
    Eigen::Vector3d p = middle;
    // By at most half a cell along two axes.
    p.x() += sites_.cell() * (uniformRandom(seed, draw.key.number, 1) - 0.5);
    p.z() += sites_.cell() * (uniformRandom(seed, draw.key.number, 2) - 0.5);
    findNear(p, radius_, startWithin(sites_.cell()));
    if (!draw.place)
    {
        findNear(middle, farthest(), startWithin(0));
    }
}

void ReleaseSites::findOut(Draw& draw, const ReleaseQuery& query) const
{
    if (!draw.isLookedAt)
    {
        lookAtSite(draw);
    }
    if (!draw.isKnown)
    {
        findPlace(draw);
        draw.stays = draw.place &&
                     (!query.prepare || query.prepare(*draw.place, draw.key.radius, draw.seen));
        draw.isKnown = true;
    }
}

void ReleaseSites::lookAhead(Draw& draw, const ReleaseQuery& query) const
{
    findOut(draw, query);
    const bool isBlocked = draw.place && draw.stays && !query.suits(*draw.place, draw.key.radius);
    draw.blockedIn = isBlocked ? query.search : 0;
}

const Draw& ReleaseSites::nextDraw(double radius, const ReleaseQuery& query,
                                   const std::function<void()>& lookAhead)
{
    const Draw::Key next = key(draws_ + 1, radius);
    if (!lookAhead)
    {
        lone_.forget();
        lone_.key = next;
        findOut(lone_, query);
        return lone_;
    }
    if (const Draw* known = ahead_.find(next))
    {
        return *known;
    }
    lookAhead();
    return *ahead_.find(next);
}

// A ceiling from which nothing can be released any more is forgotten.
const Draw& ReleaseSites::take(const Draw& draw)
{
    draws_ = draw.key.number;
    lastCeiling_ = ceilingOfDraw(draws_);
    if (!draw.place)
    {
        lastForgotten_ = draws_;
        sites_.closeSite(draw.key.site);
        dropCeiling(lastCeiling_);
    }
    return draw;
}

} // namespace frostfill

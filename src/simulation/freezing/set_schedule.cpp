// SPDX-License-Identifier: MIT
#include "simulation/freezing/set_schedule.hpp"

#include "simulation/freezing/tolerances.hpp"
#include "simulation/world/world.hpp"

#include <algorithm>

namespace frostfill
{

SetSchedule::SetSchedule(World& world, double ageLimit)
    : world_(world), keepsSets_(world.scene.freezing.rule == FreezingRule::bySet),
      ageLimit_(ageLimit), groupSize_(groupSize(world)),
      size_(groupSize_ * world.scene.spheres.groupsPerSet)
{
    startGroups();
}

// After those of the spheres that are there.
void SetSchedule::startGroups()
{
    const std::size_t spheres = world_.spheres.size();
    nextGroup_ = spheres == 0 ? 0 : world_.spheres.group(spheres - 1) + 1;
}

bool SetSchedule::isComplete() const
{
    return appeared_ >= size_ || wantedOfSet(world_, 1) == 0;
}

bool SetSchedule::isDue(std::size_t running) const
{
    return running == 0 || (!noRoom_ && mayAppearBeside(running));
}

bool SetSchedule::mayAppearBeside(std::size_t running) const
{
    if (keepsSets_)
    {
        return !isComplete() && !sleeps_;
    }
    return running <= static_cast<std::size_t>(kStillRunning * static_cast<double>(size_));
}

std::size_t SetSchedule::startSearch(std::size_t running)
{
    sleeps_ = false;
    // What of a set that is kept together finds no room at once comes later.
    if (running == 0 || !keepsSets_)
    {
        appeared_ = 0;
    }
    return wantedOfSet(world_, size_ - appeared_);
}

std::uint32_t SetSchedule::groupOf(std::size_t n) const
{
    return nextGroup_ + static_cast<std::uint32_t>(n / groupSize_);
}

void SetSchedule::endSearch(std::size_t found)
{
    noRoom_ = found == 0;
    if (found > 0)
    {
        appeared_ += found;
        placed(found);
    }
}

void SetSchedule::placed(std::size_t spheres)
{
    startGroups();
    record_.open(world_, spheres);
}

void SetSchedule::endWindow(std::span<RestWatch> running, std::vector<std::uint32_t>& sleepy)
{
    if (!keepsSets_)
    {
        noRoom_ = false;
        return;
    }
    const auto overdue = [&](const RestWatch& watch) { return watch.age > ageLimit_; };
    const bool whole = isComplete() || sleeps_ || noRoom_;
    const bool calm =
        static_cast<double>(sleepy.size()) >= kStillShare * static_cast<double>(running.size());
    stillWindows_ = whole && calm ? stillWindows_ + 1 : 0;
    if (!sleeps_ &&
        (stillWindows_ >= kStillSet || std::any_of(running.begin(), running.end(), overdue)))
    {
        sleeps_ = true;
        for (RestWatch& watch : running)
        {
            watch.stillWindows = std::min(watch.stillWindows, 1u);
        }
    }
    if (!sleeps_)
    {
        sleepy.clear();
    }
    // What is to complete a set waits until those before it have fallen out of the way.
    noRoom_ = ++windows_ % kWindowsToFall != 0;
}

} // namespace frostfill

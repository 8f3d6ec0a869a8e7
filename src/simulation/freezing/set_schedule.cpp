// SPDX-License-Identifier: MIT
#include "simulation/freezing/set_schedule.hpp"

#include "simulation/freezing/tolerances.hpp"
#include "simulation/world/world.hpp"

namespace frostfill
{

SetSchedule::SetSchedule(World& world, double ageLimit)
    : world_(world), rule_(makeFreezing(world)), ageLimit_(ageLimit), groupSize_(groupSize(world)),
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

SetProgress SetSchedule::progress(std::size_t running) const
{
    return {.size = size_,
            .running = running,
            .complete = appeared_ >= size_ || wantedOfSet(world_, 1) == 0,
            .noRoom = noRoom_,
            .ageLimit = ageLimit_};
}

bool SetSchedule::isDue(std::size_t running) const
{
    return running == 0 || (!noRoom_ && rule_->allowsRelease(progress(running)));
}

std::size_t SetSchedule::startSearch(std::size_t running)
{
    rule_->moreAppear();
    // What of a set that is kept together finds no room at once comes later.
    if (running == 0 || !rule_->keepsSets())
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
    openRecord(spheres);
}

void SetSchedule::openRecord(std::size_t spheres)
{
    record_.close(world_);
    record_.open(world_, spheres);
}

void SetSchedule::endWindow(std::span<RestWatch> running, std::vector<std::uint32_t>& sleepy)
{
    rule_->select(progress(running.size()), running, sleepy);
    // What is to complete a set waits until those before it have fallen out of the way.
    noRoom_ = rule_->keepsSets() && ++windows_ % kWindowsToFall != 0;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/engine/granular_engine.hpp"

#include "base/timers.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/engine/tolerances.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

double dragOfPour(const RestSettings& rest)
{
    return rest.fraction.value_or(1) < RestSettings::kDensest ? kDragOfLoosePour : 0;
}

} // namespace

GranularEngine::GranularEngine(World& world)
    : world_(world), threads_(world.scene.threads), grid_(world.spheres.resting().frame()),
      release_(makeRelease(world, kTopBand, threads_)), settling_(world, threads_),
      groupSize_(groupSize(world)), drag_(dragOfPour(world.scene.rest))
{
    world.clock.dt = kTimeOfPour;
}

bool GranularEngine::step()
{
    if (world_.clock.finished)
    {
        return false;
    }
    switch (phase_)
    {
    case Phase::rests:
        if (!pourAgain() && !world_.stop.isAsked())
        {
            finish();
            return false;
        }
        break;
    case Phase::pours:
        pour();
        break;
    case Phase::settles:
        settle();
        break;
    }
    return true;
}

// What appears is looked for while the others still rest, as only that finds every place.
bool GranularEngine::pourAgain()
{
    const std::vector<PlacedSphere> found = search();
    if (found.empty())
    {
        return false;
    }
    settling_.wakeAll();
    admit(found);
    phase_ = Phase::pours;
    return true;
}

void GranularEngine::pour()
{
    admit(search());
    {
        const StageTimer timer(world_.counts.times, Stage::motion);
        settling_.flowFor(kTimeOfPour, drag_);
    }
    sinceAdmitted_ += kTimeOfPour;
    if (isOver())
    {
        record_.close(world_);
        record_.open(world_, 0);
        settling_.begin();
        world_.clock.settles = true;
        phase_ = Phase::settles;
    }
}

// What has just appeared is slow, too.
bool GranularEngine::isOver() const
{
    const bool isCalm = settling_.isCalm() && settling_.unrest().speed < kSpeedOfPour;
    const double timeToSink = drag_ * world_.height; // at the speed at which drag is weight
    const double longest = world_.scene.motion.restitution < 1
                               ? kLongestPour
                               : kElasticFalls * std::sqrt(2 * world_.height);
    return (sinceAdmitted_ > kTimeToFall && isCalm) || sinceAdmitted_ > longest + timeToSink;
}

void GranularEngine::settle()
{
    const StageTimer timer(world_.counts.times, Stage::settling);
    if (!settling_.step())
    {
        return;
    }
    record_.close(world_);
    world_.clock.settles = false;
    phase_ = Phase::rests;
    release_ = makeRelease(world_, kTopBand, threads_); // it sees what rests
}

// The rest of the set that finds no room now does not wait for any: the next look begins a new one.
std::vector<PlacedSphere> GranularEngine::search()
{
    const StageTimer timer(world_.counts.times, Stage::releasing);
    const std::size_t wanted = wantedOfSet(world_, groupSize_ * world_.scene.spheres.groupsPerSet);
    std::vector<PlacedSphere> found;
    releaseAmong(world_.spheres.running(), grid_, wanted, *release_, {}, world_.stop,
                 [&](const PlacedSphere& sphere) { found.push_back(sphere); });
    return found;
}

void GranularEngine::admit(std::span<const PlacedSphere> spheres)
{
    if (spheres.empty())
    {
        return;
    }
    for (std::size_t k = 0; k < spheres.size(); ++k)
    {
        const auto group = nextGroup_ + static_cast<std::uint32_t>(k / groupSize_);
        world_.spheres.add(spheres[k].place, spheres[k].radius, group);
    }
    nextGroup_ = world_.spheres.group(world_.spheres.size() - 1) + 1;
    settling_.admit();
    record_.close(world_);
    record_.open(world_, spheres.size());
    sinceAdmitted_ = 0;
}

void GranularEngine::releaseAt(std::span<const PlacedSphere> spheres)
{
    requireInside(world_, spheres);
    std::vector<PlacedSphere> placed;
    for (PlacedSphere one : spheres)
    {
        if (!depenetrate(world_, one.place, one.radius, kFarRelease) ||
            !isClearOf(grid_, one.place, one.radius))
        {
            refuseOverlap(world_, one);
        }
        grid_.insert(static_cast<std::uint32_t>(placed.size()), one.place, one.radius);
        placed.push_back(one);
    }
    admit(placed);
    phase_ = Phase::pours;
}

void GranularEngine::finish()
{
    endForWantOfPlaces(world_, *release_);
    world_.clock.finished = true;
}

} // namespace frostfill

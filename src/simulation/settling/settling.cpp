// SPDX-License-Identifier: MIT
#include "simulation/settling/settling.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace frostfill
{
namespace
{

ContactLaw lawOf(const World& world)
{
    const RestSettings& rest = world.scene.rest;
    return {.stiffness = kStiffnessOfHeight * std::max(1.0, world.height),
            .dampingRatio = std::min(kMostDamping, dampingRatioFor(world.scene.motion.restitution)),
            .friction = rest.friction,
            .wallFriction = rest.wallFriction.value_or(rest.friction),
            .rollingFriction = rest.rollingFriction};
}

} // namespace

Settling::Settling(World& world, Threads& threads)
    : world_(world), running_(world.spheres.running()), motion_(world, lawOf(world), threads)
{
    if (!world.scene.rest.fraction)
    {
        return;
    }
    bulk_.emplace(world.surface, world.inside, 1, 1, threads);
    if (!bulk_->any())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("no place of the object is {:g} radii away from its walls, so it "
                                "has no bulk to pack to rest.fraction (--fraction): omit it, or "
                                "choose a smaller radius",
                                kBulkBeyond));
    }
}

void Settling::wakeAll()
{
    const std::size_t known = order_.size();
    order_.resize(world_.spheres.size());
    std::iota(order_.begin() + static_cast<std::ptrdiff_t>(known), order_.end(),
              static_cast<std::uint32_t>(known));
    wakeInOrder(known);
    motion_.listAnew();
}

void Settling::admit()
{
    for (std::size_t id = order_.size(); id < world_.spheres.size(); ++id)
    {
        order_.push_back(static_cast<std::uint32_t>(id));
        mass_ += massOf(world_.spheres.radius(id));
    }
    motion_.listAnew();
}

void Settling::begin()
{
    compactions_ = 0;
    reloads_ = 0;
    isDensest_ = false;
    startFlow();
    ++world_.clock.settling.rounds;
}

// Those that ran before get the same rows as then, which what contacts know goes by. New ones run
// behind them, side by side where they lie side by side.
void Settling::wakeInOrder(std::size_t first)
{
    const auto key = [this](std::uint32_t id)
    {
        const auto [x, y, z] =
            world_.spheres.resting().frame().coordinates(world_.spheres.position(id));
        return std::tuple(z, y, x, id);
    };
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(first), order_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    mass_ = 0;
    for (const std::uint32_t id : order_)
    {
        mass_ += massOf(world_.spheres.radius(id));
        world_.spheres.wake(id);
    }
}

bool Settling::step()
{
    switch (phase_)
    {
    case Phase::compacts:
        compact();
        return false;
    case Phase::stacks:
        return stack();
    case Phase::flows:
        flow();
        return false;
    case Phase::hardens:
        break;
    }
    return harden();
}

// Softly, and without friction if the bulk is to grow denser.
void Settling::startFlow()
{
    inPhase_ = 0;
    motion_.stiffen(1 / stiffened_);
    stiffened_ = 1;
    const double missing = missingFraction();
    startRest();
    if (missing > kFractionMissing)
    {
        phase_ = Phase::compacts;
        ++compactions_;
        motion_.setFriction(0, 0);
    }
}

void Settling::compact()
{
    givesWay_ = true;
    const bool isNear = missingOfMeasured() < kSlowlyFrom;
    advanceByImpulses(kTimeOfCompaction, isNear ? kDragOfStop : kDragOfCompaction);
    isDensest_ = isCalm() || inPhase_ >= kLongestFlow;
    if (isDensest_ || missingFraction() <= 0)
    {
        const ContactLaw law = lawOf(world_);
        motion_.setFriction(law.friction, law.wallFriction);
        startRest();
    }
}

void Settling::startRest()
{
    const ContactLaw law = lawOf(world_);
    const bool isHeld = std::min(law.friction, law.wallFriction) >= kLeastFrictionOfImpulses;
    phase_ = isHeld && isOfOneSize() ? Phase::stacks : Phase::flows;
    inPhase_ = 0;
}

void Settling::flow()
{
    flowFor(kTimeOfLook);
    if (isCalm() || inPhase_ >= kLongestFlow)
    {
        phase_ = Phase::hardens;
        inPhase_ = 0;
    }
}

void Settling::flowFor(double time, double drag)
{
    givesWay_ = true;
    motion_.takeSprings(true);
    const double before = motion_.energy();
    advance(time, {0, drag});
    world_.counts.energy.enter(before, motion_.energy(), mass_ * world_.height);
}

void Settling::advance(double time, const GranularMotion::Course& course)
{
    motion_.advance(time, course);
    countStep(time);
}

void Settling::countStep(double time)
{
    ++world_.clock.steps;
    world_.clock.time += time;
    inPhase_ += time;
}

// Lifts spheres by what has weighed them down: work that is not counted.
bool Settling::harden()
{
    if (inPhase_ >= kStiffensAfter && stiffened_ < kStiffest)
    {
        motion_.stiffen(kStiffer);
        stiffened_ *= kStiffer;
    }
    advance(kTimeOfLook, {1 / kHardening, kDrag, kFastestHardening});
    if (!rests() && canBeRelieved())
    {
        motion_.relieve();
    }
    if (!rests() && inPhase_ < kLongestHardening)
    {
        return false;
    }
    if (!rests() && reloads_ < kMostReloads && motion_.liftOutOfWalls())
    {
        ++reloads_;
        startFlow();
        return false;
    }
    if (rests() && isPinched() && !standsAnew())
    {
        return false;
    }
    return end();
}

bool Settling::end()
{
    report();
    if (!hasCompacted())
    {
        startFlow();
        return false;
    }
    freeze();
    return true;
}

void Settling::advanceByImpulses(double time, double drag)
{
    motion_.advanceByImpulses(time, {0, drag, kFastestHardening}, givesWay_);
    countStep(time);
}

// Once almost no sphere moves, the overlaps are removed, and contacts are rigid from then on.
bool Settling::stack()
{
    advanceByImpulses(kTimeOfLook, kDrag);
    if (givesWay_ && isCalm() && !hasCompacted())
    {
        startFlow();
        return false;
    }
    const double overlap = motion_.unrest().overlap;
    if (isStacked() && overlap > kOverlapAtRest && overlap < kOverlapOfImpulses)
    {
        motion_.relieve();
        givesWay_ = false;
    }
    if (isStacked() && rests())
    {
        return end();
    }
    if (inPhase_ >= kLongestImpulses)
    {
        phase_ = Phase::flows;
        inPhase_ = 0;
    }
    return false;
}

bool Settling::isStacked() const
{
    const Unrest& unrest = motion_.unrest();
    const auto count = static_cast<double>(running_.size());
    return static_cast<double>(unrest.moving) <= kMovingOfImpulses * count &&
           static_cast<double>(unrest.creeping) <= kFewMove * count &&
           unrest.missing <= kMissingAtRest && unrest.loose == 0;
}

bool Settling::isCalm() const
{
    return motion_.fewMove();
}

bool Settling::balances() const
{
    const Unrest& unrest = motion_.unrest();
    return static_cast<double>(unrest.moving) <= mostMoving() && unrest.missing <= kMissingAtRest;
}

double Settling::mostMoving() const
{
    const auto count = static_cast<double>(running_.size());
    return std::max(kMovingAtRest * count, std::min(kFewMoveAtRest, kFewMove * count));
}

bool Settling::rests() const
{
    return balances() && motion_.unrest().overlap <= kOverlapAtRest;
}

// What creeps would go on without drag.
bool Settling::canBeRelieved() const
{
    const Unrest& unrest = motion_.unrest();
    return balances() && unrest.overlap < kOverlapRelieved &&
           static_cast<double>(unrest.creeping) <= kFewMove * static_cast<double>(running_.size());
}

// What resists rolling pinches spheres, and so do large ones about a small one: forces that
// contacts have kept hold it between two others that nothing else presses together. A program that
// knows only places would let it fall. So all forces are forgotten until the pile stays where it
// is.
bool Settling::standsAnew()
{
    if (reloads_ == kMostReloads || (reloads_ > 0 && hasStayed()))
    {
        return true;
    }
    ++reloads_;
    inPhase_ = 0;
    const auto places = running_.position.all();
    restedAt_.assign(places.begin(), places.end());
    motion_.forget();
    return false;
}

bool Settling::isPinched() const
{
    const RestSettings& rest = world_.scene.rest;
    return rest.rollingFriction > 0 || (rest.friction > 0 && !isOfOneSize());
}

bool Settling::isOfOneSize() const
{
    return world_.radii.smallest() == world_.radii.largest();
}

bool Settling::hasStayed() const
{
    std::size_t moved = 0;
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        const double way = (running_.position[row] - restedAt_[row]).norm();
        moved += way > kStays * running_.radius[row] ? 1 : 0;
    }
    return static_cast<double>(moved) <= kMovingAtRest * static_cast<double>(running_.size());
}

// Below 0 where the bulk is denser than asked; 0 where there is none.
double Settling::missingFraction()
{
    if (bulk_)
    {
        world_.clock.settling.fraction =
            bulk_->fraction(running_.position.all(), running_.radius.all());
    }
    return missingOfMeasured();
}

// Of the last measurement.
double Settling::missingOfMeasured() const
{
    const auto& reached = world_.clock.settling.fraction;
    return reached ? *world_.scene.rest.fraction - *reached : 0;
}

bool Settling::hasCompacted()
{
    return missingFraction() <= kFractionMissing || isDensest_ || compactions_ >= kMostCompactions;
}

void Settling::report()
{
    SettlingReport& report = world_.clock.settling;
    report.settled = rests();
    report.missing = motion_.unrest().missing;
    report.overlap = motion_.unrest().overlap;
    report.moving = motion_.unrest().moving;
    report.mayMove = static_cast<std::size_t>(mostMoving());
}

void Settling::freeze()
{
    for (std::uint32_t id = 0; id < world_.spheres.size(); ++id)
    {
        world_.spheres.freeze(id);
    }
    world_.spheres.closeRanks();
}

} // namespace frostfill

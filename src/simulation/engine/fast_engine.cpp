// SPDX-License-Identifier: MIT
#include "simulation/engine/fast_engine.hpp"

#include "base/stage_timer.hpp"
#include "simulation/contact/depenetration.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kStep = 0.165;        // default time step [sqrt(r/g) of the smallest sphere]
constexpr double kSkipStep = 0.33;     // the same with Motion::skip, where nothing falls from far
constexpr double kLongestStep = 0.33;  // a longer one is divided [sqrt(r/g) of the smallest]
constexpr double kWindow = 0.33;       // over which a sphere is watched [sqrt(r/g)]
constexpr double kWaiting = 0.05;      // how fast a sphere ages that only runners hold up
constexpr double kStillRunning = 0.2;  // share of a set that may run when the next one appears
constexpr int kSweepsInAvalanche = 40; // of encounters at most, where whole piles run at once
constexpr double kCarries = 0.1;       // part of a contact's force that is vertical, at least
constexpr double kLiveliest = 0.95;    // restitution that is given the time to come to rest
constexpr double kTopBand = 4;         // below the highest ceiling, in which falls begin [r]
constexpr std::uint32_t kWindowsToFall = 9; // as a sphere takes from the top to below the band
constexpr double kFarRelease = 4; // a sphere that is released in a wall is moved by less [r]

double timeStep(const World& world)
{
    if (world.scene.motion.dt)
    {
        // In longer steps gravity alone makes spheres in contact too fast to come to rest.
        const double longest = kLongestStep * std::sqrt(world.radii.smallest());
        const double asked = *world.scene.motion.dt / world.frame.time;
        return asked / std::ceil(asked / longest);
    }
    const bool quiet = world.scene.motion.mode == Motion::skip && !world.scene.move.any();
    const double step = quiet ? kSkipStep : kStep;
    return step * std::sqrt(world.radii.smallest());
}

// What a sphere may take that falls through the object and bounces on its floor, with time to
// spare.
double timeToBounce(const World& world)
{
    const double fall = std::sqrt(2 * world.height);
    const double e = std::min(world.scene.motion.restitution, kLiveliest);
    return fall * std::max(4.0, (1 + e) / (1 - e));
}

} // namespace

FastEngine::FastEngine(World& world)
    : world_(world), threads_(world.scene.threads), falls_(world.resting.frame(), world.triangles),
      release_(std::in_place, world,
               world.scene.motion.mode == Motion::fall ? kTopBand : world.height, threads_),
      dropAndRoll_(world, falls_), flight_(world, {world.scene.motion.restitution}),
      grid_(world.resting.frame()),
      positionSolver_(grid_, flight_, threads_,
                      {.restitution = world.scene.motion.restitution,
                       .sweeps = world.scene.move.any()
                                     ? std::max(kSweepsInAvalanche, world.scene.motion.sweeps)
                                     : world.scene.motion.sweeps,
                       .stiff = !world.scene.freezing.bySet}),
      carried_(flight_, threads_), setSize_(groupSize(world) * world.scene.spheres.groupsPerSet),
      layer_(spheresInLayer(world)),
      ageLimit_(world.scene.freezing.setTimeLimit + timeToBounce(world))
{
    if (!release_->any())
    {
        refuseTooLarge(world);
    }
    if (world.scene.discard.rule == DiscardRule::exact)
    {
        const StageTimer timer(world.times, Stage::discarding);
        discard_ = std::make_unique<ExactDiscard>(world);
    }
    world.dt = timeStep(world);
    windowSteps_ = std::max(1u, static_cast<std::uint32_t>(std::lround(kWindow / world.dt)));
}

bool FastEngine::step()
{
    if (world_.finished)
    {
        return false;
    }
    // A search that found nothing is not repeated before the runners have moved on.
    const auto few = static_cast<std::size_t>(kStillRunning * static_cast<double>(setSize_));
    const bool due = world_.scene.freezing.bySet ? !setIsWhole() : running_ <= few;
    if (!moving_ && (running_ == 0 || (due && mayRelease_)))
    {
        mayRelease_ = releaseSet();
    }
    if (running_ == 0 && !followObject())
    {
        finish();
        return false;
    }
    advance();
    ++world_.steps;
    world_.time += world_.dt;
    if (moving_)
    {
        world_.pull = world_.motion.pullAt(world_.time - world_.motionStart);
    }
    if (++stepsInWindow_ == windowSteps_)
    {
        const StageTimer timer(world_.times, Stage::freezing);
        stepsInWindow_ = 0;
        energy_.reset();
        freezeSleepy();
        // What is to complete a set waits until those before it have fallen out of the way.
        mayRelease_ = !world_.scene.freezing.bySet || ++windows_ % kWindowsToFall == 0;
        wakeWhenDue();
    }
    if (discard_)
    {
        const StageTimer timer(world_.times, Stage::discarding);
        discard_->afterStep({runners_.data(), running_});
    }
    return true;
}

void FastEngine::finish()
{
    world_.full = world_.targetCount == 0 || world_.spheres.size() < world_.targetCount;
    world_.finished = true;
    if (motionIsOver_ && world_.scene.discard.rule == DiscardRule::exact)
    {
        discard_ = std::make_unique<ExactDiscard>(world_);
        for (std::uint32_t id = 0; id < world_.spheres.size(); ++id)
        {
            discard_->addResting(id);
        }
    }
    if (discard_)
    {
        const StageTimer timer(world_.times, Stage::discarding);
        discard_->finish(world_.full);
    }
    clock_.close(world_);
}

bool FastEngine::releaseSet()
{
    const StageTimer timer(world_.times, Stage::releasing);
    std::size_t wanted = setSize_;
    if (world_.scene.freezing.bySet)
    {
        // What of a set finds no room at once comes later.
        inSet_ = running_ == 0 ? 0 : inSet_;
        setSleeps_ = false;
        wanted -= inSet_;
    }
    if (world_.targetCount > 0)
    {
        wanted = std::min(wanted, world_.targetCount - world_.spheres.size());
    }
    const std::size_t before = world_.spheres.size();
    // Free flight is analytic: with Motion::skip a sphere appears where it would touch first.
    const bool skip = world_.scene.motion.mode == Motion::skip;
    grid_.rebuild({runners_.data(), running_});
    release_->forgetAhead();
    const auto fall = [&](Eigen::Vector3d place, double radius)
    {
        if (skip)
        {
            dropAndRoll_.drop(place, radius);
        }
        return place;
    };
    const auto suits = [this](const Eigen::Vector3d& place, double radius)
    { return clearOfRunners(place, radius); };
    while (world_.spheres.size() - before < wanted)
    {
        const auto found = release_->find(fall, suits, true);
        if (!found)
        {
            break;
        }
        const std::size_t inSet = world_.spheres.size() - before;
        const auto group = nextGroup_ + static_cast<std::uint32_t>(inSet / groupSize(world_));
        start(found->place, found->radius, group);
        grid_.add(found->place, found->radius);
    }
    if (world_.spheres.size() == before)
    {
        return false;
    }
    inSet_ += world_.spheres.size() - before;
    openSet(world_.spheres.size() - before);
    return true;
}

void FastEngine::start(const Eigen::Vector3d& place, double radius, std::uint32_t group)
{
    energy_.reset();
    const std::uint32_t id = world_.release(place, radius, group);
    if (running_ == runners_.size())
    {
        runners_.emplace_back();
    }
    runners_[running_++].restart(id, place, radius);
}

void FastEngine::openSet(std::size_t spheres)
{
    nextGroup_ = world_.spheres.group.back() + 1;
    clock_.close(world_);
    clock_.open(world_, spheres);
}

// Those that overlap are taken apart first, so that they do not start by flying apart.
void FastEngine::releaseAt(std::span<const PlacedSphere> spheres)
{
    requireInside(world_, spheres);
    for (const PlacedSphere& one : spheres)
    {
        Eigen::Vector3d place = one.place;
        if (!depenetrate(world_, place, one.radius, kFarRelease))
        {
            refuseCrowdedPlace(world_, one);
        }
        start(place, one.radius, nextGroup_);
    }
    openSet(spheres.size());
    positionSolver_.separate({runners_.data(), running_});
    for (std::size_t k = 0; k < running_; ++k)
    {
        world_.spheres.setPosition(runners_[k].id, runners_[k].position);
        runners_[k].watched = runners_[k].position;
    }
}

double FastEngine::runningEnergy() const
{
    double energy = 0;
    for (std::size_t k = 0; k < running_; ++k)
    {
        const Runner& runner = runners_[k];
        const double mass = runner.radius * runner.radius * runner.radius;
        energy +=
            mass * (runner.velocity.squaredNorm() / 2 + world_.frame.gravity * runner.position.y());
    }
    return energy;
}

void FastEngine::advance()
{
    const bool gravityChanges =
        moving_ && world_.time - world_.motionStart < world_.motion.duration();
    const std::span<Runner> runners(runners_.data(), running_);
    // A moving object does work on the spheres, which is not counted.
    const double energyBefore = moving_ ? 0 : energy_ ? *energy_ : runningEnergy();
    {
        const StageTimer timer(world_.times, Stage::motion);
        threads_.forEach(runners.size(),
                         [&](std::size_t i)
                         {
                             flight_.advance(runners[i], world_.dt);
                             // While the object moves, nothing is due to be at rest.
                             runners[i].age += gravityChanges ? 0 : ageing(runners[i]) * world_.dt;
                         });
    }
    {
        const StageTimer timer(world_.times, Stage::sphereSphere);
        positionSolver_.resolve(runners, world_.dt);
    }
    std::uint64_t pairs = 0;
    double mass = 0;
    for (const Runner& runner : runners)
    {
        mass += runner.radius * runner.radius * runner.radius;
        world_.spheres.setPosition(runner.id, runner.position);
        world_.spheres.setVelocity(runner.id, runner.velocity);
        world_.operations.runningFrozenTests += runner.around.spheres();
        world_.operations.spherePolygonTests += runner.around.triangles().size();
        pairs += runner.nearby.size();
    }
    world_.operations.runningRunningTests += pairs / 2;
    energy_.reset();
    if (!moving_)
    {
        energy_ = runningEnergy();
        world_.energy.enter(energyBefore, *energy_, mass * world_.height);
    }
}

// A pile comes to rest from below: what lies on others that still run has to wait for them.
double FastEngine::ageing(const Runner& runner) const
{
    const Eigen::Vector3d down = world_.pull.direction(runner.position);
    const auto carries = [&](const Eigen::Vector3d& normal)
    { return normal.dot(down) < -kCarries; };
    const bool carried = std::any_of(runner.normals.begin(), runner.normals.end(), carries);
    return carried || runner.nearby.empty() ? 1 : kWaiting;
}

bool FastEngine::clearOfRunners(const Eigen::Vector3d& place, double radius) const
{
    bool clear = true;
    grid_.forEachNear(place, radius + 1 + kClearance,
                      [&](std::uint32_t, const Eigen::Vector3d& p, double radiusThere)
                      {
                          const double contact = radiusThere + radius + kClearance;
                          clear = clear && (p - place).squaredNorm() >= contact * contact;
                      });
    return clear;
}

} // namespace frostfill

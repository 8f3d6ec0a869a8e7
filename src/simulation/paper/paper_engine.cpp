// SPDX-License-Identifier: MIT
#include "simulation/paper/paper_engine.hpp"

#include "base/stage_timer.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/paper/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

double fallTime(double height)
{
    return std::sqrt(2 * height);
}
double fallSpeed(double height)
{
    return std::sqrt(2 * height);
}

double chooseTimeStep(const World& world)
{
    if (world.scene.motion.dt)
    {
        return *world.scene.motion.dt / world.frame.time;
    }
    const double smallest = world.radii.smallest();
    return std::min(kPaperLongestStep * std::sqrt(smallest),
                    kLongestFall * smallest / fallSpeed(world.height));
}

RestMonitor restMonitor(const World& world)
{
    const FreezingSettings& freezing = world.scene.freezing;
    const double steps = std::ceil(freezing.restWindow / chooseTimeStep(world));
    return {static_cast<std::uint32_t>(std::clamp(steps, 1.0, kLongestWindow)),
            freezing.restSpeed * freezing.restWindow};
}

} // namespace

PaperEngine::PaperEngine(World& world)
    : world_(world), integrator_(integrators()[world.scene.motion.integrator]()),
      spheres_(sphereSearches()[world.scene.search.spheres](world.resting)),
      polygons_(polygonSearches()[world.scene.search.polygons](
          {world.surface, world.polygons, &world.triangles, kQuarterReach})),
      algorithm1_(world.spheres, world.surface, *polygons_,
                  {world.scene.motion.restitution,
                   kBounceSteps * world.frame.gravity * chooseTimeStep(world)},
                  spheres_.get()),
      release_(makeRelease(world, kPaperTopBand, threads_)), discard_(makeDiscard(world)),
      rest_(restMonitor(world)),
      setTimeLimit_(world.scene.freezing.setTimeLimit + 2 * fallTime(world.height))
{
    world.dt = chooseTimeStep(world);
    if (!release_->any())
    {
        refuseTooLarge(world);
    }
}

bool PaperEngine::step()
{
    if (world_.finished)
    {
        return false;
    }
    if (setIsOver_ && !startNextSet())
    {
        world_.finished = true;
        return false;
    }
    const double energyBefore = runningEnergy();
    integrate();
    collide();
    world_.energy.enter(energyBefore, runningEnergy(), fallEnergy_);
    ++world_.steps;
    world_.time += world_.dt;
    setTime_ += world_.dt;
    observeRest();
    return true;
}

// Called when the newest set has come to rest. Returns false when the run is over.
bool PaperEngine::startNextSet()
{
    const std::uint32_t every = world_.scene.freezing.everySets;
    if (every > 0 && setsAtRest_ >= every)
    {
        freezeAndDiscard();
    }
    if (releaseSet())
    {
        return true;
    }
    // Whatever still runs is at rest; once it is frozen the search sees it as it will stay.
    freezeAndDiscard();
    if (releaseSet())
    {
        return true;
    }
    world_.full = world_.targetCount == 0 || world_.spheres.size() < world_.targetCount;
    clock_.close(world_);
    return false;
}

bool PaperEngine::releaseSet()
{
    const SphereSettings& settings = world_.scene.spheres;
    std::size_t wanted = static_cast<std::size_t>(settings.groupSize) * settings.groupsPerSet;
    if (world_.targetCount > 0)
    {
        wanted = std::min(wanted, world_.targetCount - world_.spheres.size());
    }
    if (wanted == 0)
    {
        return false;
    }
    const std::size_t before = world_.spheres.size();
    {
        const StageTimer timer(world_.times, Stage::releasing);
        const ReleaseQuery query = {.suits = [this](const Eigen::Vector3d& place, double radius)
                                    { return clearOfRunning(place, radius); }};
        while (world_.spheres.size() - before < wanted)
        {
            const auto found = release_->next(query);
            if (!found)
            {
                break;
            }
            const std::size_t inSet = world_.spheres.size() - before;
            world_.release(found->place, found->radius,
                           nextGroup_ + static_cast<std::uint32_t>(inSet / settings.groupSize));
        }
    }
    if (world_.spheres.size() == before)
    {
        return false;
    }
    startSet(world_.spheres.size() - before);
    return true;
}

void PaperEngine::startSet(std::size_t spheres)
{
    clock_.close(world_);
    clock_.open(world_, spheres);
    nextGroup_ = world_.spheres.group.back() + 1;
    setIsOver_ = false;
    setTime_ = 0;
    rest_.restart(world_.spheres, world_.restingCount);
    fallEnergy_ = 0;
    for (std::size_t i = world_.restingCount; i < world_.spheres.size(); ++i)
    {
        fallEnergy_ += world_.height * massOf(world_.spheres.radius[i]);
    }
}

void PaperEngine::releaseAt(std::span<const PlacedSphere> spheres)
{
    requireInside(world_, spheres);
    for (const PlacedSphere& one : spheres)
    {
        world_.release(one.place, one.radius, nextGroup_);
    }
    startSet(spheres.size());
}

bool PaperEngine::clearOfRunning(const Eigen::Vector3d& place, double radius) const
{
    for (std::size_t id = world_.restingCount; id < world_.spheres.size(); ++id)
    {
        if (isWithin(world_.spheres.position(id), place,
                     world_.spheres.radius[id] + radius + kClearance))
        {
            return false;
        }
    }
    return true;
}

void PaperEngine::freezeAndDiscard()
{
    {
        const StageTimer timer(world_.times, Stage::freezing);
        while (world_.restingCount < world_.spheres.size())
        {
            const auto id = static_cast<std::uint32_t>(world_.restingCount);
            world_.freeze(id);
            release_->close(world_.spheres.position(id), world_.spheres.radius[id]);
            if (discard_)
            {
                discard_->addResting(id);
            }
        }
        world_.forgetFrozen();
        setsAtRest_ = 0;
    }
    if (discard_)
    {
        const StageTimer timer(world_.times, Stage::discarding);
        discard_->afterFreezing();
        const auto isDiscarded = [this](std::size_t id)
        { return world_.spheres.state[id] == SphereState::discarded; };
        while (firstFrozen_ < world_.restingCount && isDiscarded(firstFrozen_))
        {
            ++firstFrozen_;
        }
        polygons_->update();
    }
}

void PaperEngine::integrate()
{
    const StageTimer timer(world_.times, Stage::motion);
    const Spheres& spheres = world_.spheres;
    const auto collect = [&](std::vector<Eigen::Vector3d>& positions)
    {
        positions.clear();
        for (std::size_t i = world_.restingCount; i < spheres.size(); ++i)
        {
            positions.push_back(spheres.position(i));
        }
    };
    collect(before_);
    integrator_->advance(world_.spheres, world_.restingCount, world_.frame.gravity, world_.dt);
    collect(predicted_);
}

// PAPER, Algorithm 1: the three cycles of one time step.
void PaperEngine::collide()
{
    const std::size_t runningBegin = world_.restingCount;
    algorithm1_.clearTouched(world_.running());
    double sphereSphere = 0;
    double spherePolygon = 0;
    {
        const StageTimer timer(world_.times, Stage::sphereSphere);
        algorithm1_.runningRunning(runningBegin, world_.operations);
        algorithm1_.runningFrozen(firstFrozen_, runningBegin, world_.operations);
        limitPushes();
        sphereSphere = timer.seconds();
    }
    {
        const StageTimer timer(world_.times, Stage::spherePolygon);
        algorithm1_.runningPolygons(runningBegin, before_, world_.operations);
        spherePolygon = timer.seconds();
    }
    clock_.observe(1e3 * sphereSphere, 1e3 * spherePolygon);
}

void PaperEngine::limitPushes()
{
    for (std::size_t k = 0; k < predicted_.size(); ++k)
    {
        const std::size_t id = world_.restingCount + k;
        const Eigen::Vector3d push = world_.spheres.position(id) - predicted_[k];
        const double length = push.norm();
        const double longest = kPaperLongestPush * world_.spheres.radius[id];
        if (length > longest)
        {
            world_.spheres.setPosition(id, predicted_[k] + push * (longest / length));
        }
    }
}

void PaperEngine::observeRest()
{
    const StageTimer timer(world_.times, Stage::motion);
    const bool atRest = rest_.observe(world_.spheres, world_.restingCount, algorithm1_.touched(),
                                      [this](std::size_t id) { return isLost(id); });
    const bool timedOut = !atRest && setTime_ > setTimeLimit_;
    if (timedOut)
    {
        clock_.markTimedOut();
        world_.overdue += world_.running();
    }
    if (atRest || timedOut)
    {
        setIsOver_ = true;
        ++setsAtRest_;
    }
}

double PaperEngine::runningEnergy() const
{
    const Spheres& s = world_.spheres;
    double energy = 0;
    for (std::size_t i = world_.restingCount; i < s.size(); ++i)
    {
        energy +=
            massOf(s.radius[i]) * (s.velocity(i).squaredNorm() / 2 + world_.frame.gravity * s.y[i]);
    }
    return energy;
}

bool PaperEngine::isLost(std::size_t id) const
{
    const Eigen::Vector3d p = world_.spheres.position(id);
    return !p.allFinite() || world_.surface.box().exteriorDistance(p) > kLost;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/paper/paper_engine.hpp"

#include "base/timers.hpp"
#include "simulation/contact/depenetration.hpp"
#include "simulation/paper/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{

std::size_t discardByHeight(World& world, std::size_t firstFrozen, std::size_t frozenEnd,
                            double epsilon)
{
    if (frozenEnd == 0)
    {
        return firstFrozen;
    }
    const Spheres& s = world.spheres;
    const std::uint32_t lastGroup = s.group(frozenEnd - 1);
    double lowestOfLast = std::numeric_limits<double>::infinity();
    for (std::size_t id = frozenEnd; id > 0 && s.group(id - 1) == lastGroup; --id)
    {
        lowestOfLast = std::min(lowestOfLast, s.position(id - 1).y());
    }

    // Groups go in the order in which they came, so that those that stay remain one range.
    while (firstFrozen < frozenEnd && s.group(firstFrozen) != lastGroup)
    {
        std::size_t end = firstFrozen;
        bool below = true;
        for (; end < frozenEnd && s.group(end) == s.group(firstFrozen); ++end)
        {
            below = below && lowestOfLast - s.position(end).y() > epsilon;
        }
        if (!below)
        {
            break;
        }
        for (; firstFrozen < end; ++firstFrozen)
        {
            world.spheres.discard(static_cast<std::uint32_t>(firstFrozen));
        }
    }
    return firstFrozen;
}

namespace
{

/// Whether the ray from `vertex` along `direction` enters a sphere at rest within `closeness`.
bool isCovered(const World& world, const Eigen::Vector3d& vertex, const Eigen::Vector3d& direction,
               double closeness)
{
    bool covered = false;
    // Centres of spheres that the ray enters that soon are within this of the ray's first half.
    const double reach = 1 + closeness / 2;
    const SphereGrid& resting = world.spheres.resting();
    resting.forEachNear(vertex + direction * (closeness / 2), reach,
                        [&](std::uint32_t row)
                        {
                            const Eigen::Vector3d toCentre = resting[row].position() - vertex;
                            const double radius = resting[row].radius;
                            const double along = toCentre.dot(direction);
                            const double missSquared = (toCentre - along * direction).squaredNorm();
                            if (along >= 0 && missSquared <= radius * radius)
                            {
                                const double entry =
                                    along - std::sqrt(radius * radius - missSquared);
                                covered = covered || entry <= closeness;
                            }
                        });
    return covered;
}

} // namespace

std::size_t discardCoveredPolygons(World& world, double closeness)
{
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < world.surface.size(); ++t)
    {
        if (world.polygons[t] == PolygonState::discarded)
        {
            continue;
        }
        const SurfaceTriangle& triangle = world.surface[t];
        bool covered = true;
        for (std::size_t k = 0; k < 3 && covered; ++k)
        {
            const Eigen::Vector3d normal =
                world.surface.vertexNormal(world.surface.mesh().triangles[t][k]);
            covered = isCovered(world, triangle.corner[k], normal, closeness);
        }
        if (covered)
        {
            world.discardPolygon(t);
            ++count;
        }
    }
    return count;
}

namespace
{

/// The time of a fall, and the speed at its end, in the run's units.
double fallTime(double height)
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
                    kLongestFall * smallest / fallTime(world.height));
}

/// Euler's method. The position follows the velocity before the step (explicit) or after it
/// (semi-implicit).
void fallFreely(RunningSpheres& running, Integrator integrator, double gravity, double dt)
{
    const double fall = gravity * dt;
    for (std::uint32_t i = 0; i < running.size(); ++i)
    {
        const Eigen::Vector3d velocity = running.velocity[i];
        const Eigen::Vector3d faster = velocity - Eigen::Vector3d(0, fall, 0);
        running.position[i] += (integrator == Integrator::explicitEuler ? velocity : faster) * dt;
        running.velocity[i] = faster;
    }
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
    : world_(world), running_(world.spheres.running()),
      polygons_(makePolygonSearch(world.scene.search.polygons, {world.surface, world.polygons,
                                                                &world.triangles, kQuarterReach})),
      algorithm1_(world.spheres, world.surface, *polygons_,
                  {world.scene.motion.restitution,
                   kBounceSteps * world.frame.gravity * chooseTimeStep(world)},
                  world.scene.search.spheres == SphereSearch::grid),
      release_(makeRelease(world, kTopBand, threads_)), rest_(restMonitor(world)),
      setTimeLimit_(world.scene.freezing.setTimeLimit + 2 * fallTime(world.height))
{
    world.clock.dt = chooseTimeStep(world);
}

bool PaperEngine::step()
{
    if (world_.clock.finished)
    {
        return false;
    }
    if (setIsOver_ && !startNextSet())
    {
        return !world_.clock.finished;
    }
    const double energyBefore = energyOf(running_, world_.frame.gravity);
    integrate();
    collide();
    world_.counts.energy.enter(energyBefore, energyOf(running_, world_.frame.gravity), fallEnergy_);
    ++world_.clock.steps;
    world_.clock.time += world_.clock.dt;
    setTime_ += world_.clock.dt;
    observeRest();
    return true;
}

// Called when the newest set has come to rest. Returns whether another has begun.
bool PaperEngine::startNextSet()
{
    const std::uint32_t every = world_.scene.freezing.everySets;
    if (every > 0 && setsAtRest_ >= every)
    {
        freezeAndDiscard();
    }
    bool begins = releaseSet();
    if (!begins && !world_.stop.isAsked())
    {
        // Whatever still runs is at rest; once it is frozen the search sees it as it will stay.
        freezeAndDiscard();
        begins = releaseSet();
    }
    if (!begins && !world_.stop.isAsked())
    {
        endForWantOfPlaces(world_, *release_);
        clock_.close(world_);
        world_.clock.finished = true;
    }
    return begins;
}

bool PaperEngine::releaseSet()
{
    const SphereSettings& settings = world_.scene.spheres;
    const std::size_t wanted =
        wantedOfSet(world_, static_cast<std::size_t>(settings.groupSize) * settings.groupsPerSet);
    if (wanted == 0)
    {
        return false;
    }
    const std::size_t before = world_.spheres.size();
    {
        const StageTimer timer(world_.counts.times, Stage::releasing);
        const ReleaseQuery query = {.suits = [this](const Eigen::Vector3d& place, double radius)
                                    { return clearOfRunning(place, radius); },
                                    .stop = &world_.stop};
        while (world_.spheres.size() - before < wanted)
        {
            const auto found = release_->next(query);
            if (!found)
            {
                break;
            }
            const std::size_t inSet = world_.spheres.size() - before;
            world_.spheres.add(found->place, found->radius,
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
    clock_.open(world_, spheres);
    nextGroup_ = world_.spheres.group(world_.spheres.size() - 1) + 1;
    setIsOver_ = false;
    setTime_ = 0;
    rest_.restart(running_);
    fallEnergy_ = 0;
    for (const double radius : running_.radius.all())
    {
        fallEnergy_ += world_.height * massOf(radius);
    }
}

void PaperEngine::releaseAt(std::span<const PlacedSphere> spheres)
{
    requireInside(world_, spheres);
    for (const PlacedSphere& one : spheres)
    {
        world_.spheres.add(one.place, one.radius, nextGroup_);
    }
    startSet(spheres.size());
}

bool PaperEngine::clearOfRunning(const Eigen::Vector3d& place, double radius) const
{
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        if (isWithin(running_.position[row], place, running_.radius[row] + radius + kClearance))
        {
            return false;
        }
    }
    return true;
}

void PaperEngine::freezeAndDiscard()
{
    {
        const StageTimer timer(world_.counts.times, Stage::freezing);
        for (std::uint32_t row = 0; row < running_.size(); ++row)
        {
            const std::uint32_t id = running_.id[row];
            world_.spheres.freeze(id);
            release_->close(running_.position[row], running_.radius[row]);
        }
        world_.spheres.closeRanks();
        setsAtRest_ = 0;
    }
    const DiscardSettings& discard = world_.scene.discard;
    if (discard.rule == DiscardRule::paper)
    {
        const StageTimer timer(world_.counts.times, Stage::discarding);
        firstFrozen_ =
            discardByHeight(world_, firstFrozen_, world_.spheres.resting().size(), discard.epsilon);
        discardCoveredPolygons(world_, discard.closeness);
        polygons_->update();
    }
}

void PaperEngine::integrate()
{
    const StageTimer timer(world_.counts.times, Stage::motion);
    const std::span<const Eigen::Vector3d> positions = running_.position.all();
    before_.assign(positions.begin(), positions.end());
    fallFreely(running_, world_.scene.motion.integrator, world_.frame.gravity, world_.clock.dt);
    predicted_.assign(positions.begin(), positions.end());
}

// PAPER, Algorithm 1: the three cycles of one time step.
void PaperEngine::collide()
{
    algorithm1_.clearTouched();
    double sphereSphere = 0;
    double spherePolygon = 0;
    {
        const StageTimer timer(world_.counts.times, Stage::sphereSphere);
        algorithm1_.runningRunning(world_.counts.operations);
        algorithm1_.runningFrozen(firstFrozen_, world_.counts.operations);
        limitPushes();
        sphereSphere = timer.seconds();
    }
    {
        const StageTimer timer(world_.counts.times, Stage::spherePolygon);
        algorithm1_.runningPolygons(before_, world_.counts.operations);
        spherePolygon = timer.seconds();
    }
    clock_.observe(1e3 * sphereSphere, 1e3 * spherePolygon);
}

void PaperEngine::limitPushes()
{
    for (std::uint32_t row = 0; row < running_.size(); ++row)
    {
        const Eigen::Vector3d push = running_.position[row] - predicted_[row];
        const double length = push.norm();
        const double longest = kPaperLongestPush * running_.radius[row];
        if (length > longest)
        {
            running_.position[row] = predicted_[row] + push * (longest / length);
        }
    }
}

void PaperEngine::observeRest()
{
    const StageTimer timer(world_.counts.times, Stage::motion);
    const bool atRest = rest_.observe(running_, algorithm1_.touched(),
                                      [this](std::uint32_t row) { return isLost(row); });
    const bool timedOut = !atRest && setTime_ > setTimeLimit_;
    if (timedOut)
    {
        world_.counts.sets.back().timedOut = true;
        world_.counts.overdue += running_.size();
    }
    if (atRest || timedOut)
    {
        setIsOver_ = true;
        ++setsAtRest_;
    }
}

bool PaperEngine::isLost(std::uint32_t row) const
{
    const Eigen::Vector3d& p = running_.position[row];
    return !p.allFinite() || world_.surface.box().exteriorDistance(p) > kLost;
}

} // namespace frostfill

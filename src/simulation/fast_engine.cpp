// SPDX-License-Identifier: MIT
#include <simulation/fast_engine.hpp>

#include <simulation/clear_place.hpp>
#include <simulation/contact_cone.hpp>
#include <simulation/free_path.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kStep = 0.165;           // default time step [sqrt(r/g)]
constexpr double kWindow = 0.33;          // over which a sphere is watched [sqrt(r/g)]
constexpr double kCalm = 0.03;            // a calm sphere moves less than this in a window [r]
constexpr double kContactGap = 0.01;      // below which a contact carries, for the first look [r]
constexpr double kMostlyCarried = 0.5;    // weight that may be missing at that first look
constexpr double kLongestSettling = 0.15; // a sphere that is frozen comes down by less [r]
constexpr double kMostOverlap = 0.05;     // with a runner, of a place where a sphere is frozen [r]
constexpr std::uint32_t kPatience = 8;    // calm windows after which a sphere stops giving way
constexpr double kStillRunning = 0.2;     // share of a set that may run when the next one appears
constexpr double kFootprint = 0.1;        // share of the cross-section that a set covers by default

double timeStep(const World& world)
{
    return world.scene.motion.dt ? *world.scene.motion.dt / world.frame.time : kStep;
}

// PAPER: k gamma. By default a tenth of the mean cross-section's capacity.
std::size_t spheresInSet(const World& world)
{
    const SphereSettings& spheres = world.scene.spheres;
    const std::size_t given = std::size_t{spheres.groupSize} * spheres.groupsPerSet;
    const double volume = world.report.volume / std::pow(world.frame.length, 3);
    const double automatic = kFootprint * volume / world.height / 4;
    return std::max(given, static_cast<std::size_t>(automatic));
}

} // namespace

FastEngine::FastEngine(World& world)
    : world_(world), falls_(world.resting.frame(), world.triangles), release_(world),
      descent_(world, falls_), flight_(world, {world.scene.motion.restitution}),
      encounters_(world, flight_, {world.scene.motion.restitution}), setSize_(spheresInSet(world)),
      ageLimit_(world.scene.freezing.setTimeLimit + 4 * std::sqrt(2 * world.height))
{
    world.dt = timeStep(world);
    windowSteps_ = std::max(1u, static_cast<std::uint32_t>(std::lround(kWindow / world.dt)));
}

bool FastEngine::step()
{
    if (world_.finished)
    {
        return false;
    }
    const auto few = static_cast<std::size_t>(kStillRunning * static_cast<double>(setSize_));
    if (running_ <= few && !releaseSet() && running_ == 0)
    {
        world_.full = world_.targetCount == 0 || world_.spheres.size() < world_.targetCount;
        world_.finished = true;
        clock_.close(world_);
        return false;
    }
    advance();
    ++world_.steps;
    world_.time += world_.dt;
    if (++stepsInWindow_ == windowSteps_)
    {
        const StageTimer timer(world_.times, Stage::freezing);
        stepsInWindow_ = 0;
        freezeCalm();
    }
    return true;
}

bool FastEngine::releaseSet()
{
    const StageTimer timer(world_.times, Stage::releasing);
    std::size_t wanted = setSize_;
    if (world_.targetCount > 0)
    {
        wanted = std::min(wanted, world_.targetCount - world_.spheres.size());
    }
    const std::size_t before = world_.spheres.size();
    const auto suits = [this](const Eigen::Vector3d& place)
    {
        for (std::size_t k = 0; k < running_; ++k)
        {
            const double contact = runners_[k].radius + 1 + kClearance;
            if ((runners_[k].position - place).squaredNorm() < contact * contact)
            {
                return false;
            }
        }
        return true;
    };
    while (world_.spheres.size() - before < wanted)
    {
        const auto place = release_.find(suits);
        if (!place)
        {
            break;
        }
        const std::size_t inSet = world_.spheres.size() - before;
        const auto group =
            nextGroup_ + static_cast<std::uint32_t>(inSet / world_.scene.spheres.groupSize);
        const std::uint32_t id = world_.release(*place, 1, group);
        if (running_ == runners_.size())
        {
            runners_.emplace_back();
        }
        runners_[running_++].restart(id, *place);
    }
    if (world_.spheres.size() == before)
    {
        return false;
    }
    nextGroup_ = world_.spheres.group.back() + 1;
    clock_.close(world_);
    clock_.open(world_, world_.spheres.size() - before);
    return true;
}

void FastEngine::advance()
{
    const std::span<Runner> runners(runners_.data(), running_);
    {
        const StageTimer timer(world_.times, Stage::motion);
        for (Runner& runner : runners)
        {
            flight_.advance(runner, world_.dt);
            runner.age += world_.dt;
        }
    }
    {
        const StageTimer timer(world_.times, Stage::sphereSphere);
        encounters_.resolve(runners, world_.dt);
    }
    for (const Runner& runner : runners)
    {
        world_.spheres.setPosition(runner.id, runner.position);
        world_.spheres.setVelocity(runner.id, runner.velocity);
    }
}

// The lowest first, so that a pile freezes from below.
void FastEngine::freezeCalm()
{
    std::vector<std::uint32_t> order;
    for (std::uint32_t k = 0; k < running_; ++k)
    {
        Runner& runner = runners_[k];
        const bool calm = (runner.position - runner.watched).squaredNorm() < kCalm * kCalm;
        runner.watched = runner.position;
        runner.calmWindows = calm ? runner.calmWindows + 1 : 0;
        if (runner.calmWindows > 0 || runner.age > ageLimit_)
        {
            order.push_back(k);
        }
    }
    std::sort(order.begin(), order.end(),
              [this](std::uint32_t a, std::uint32_t b)
              {
                  const double ya = runners_[a].position.y();
                  const double yb = runners_[b].position.y();
                  return ya < yb || (ya == yb && a < b);
              });
    frozen_.assign(running_, false);
    for (const std::uint32_t k : order)
    {
        frozen_[k] = tryFreeze(runners_[k]);
    }
    forgetFrozen();
}

bool FastEngine::tryFreeze(Runner& runner)
{
    const bool tooOld = runner.age > ageLimit_;
    Eigen::Vector3d place = runner.position;
    runner.around.ensure(world_, place, runner.radius, 0);
    contactNormals(world_.surface, runner.around, place, runner.radius, kContactGap,
                   runner.normals);
    const double missing = projectToFree({0, -1, 0}, runner.normals).norm();
    if (missing > kMostlyCarried && !tooOld)
    {
        runner.yields = runner.calmWindows < kPatience;
        return false;
    }
    if (!moveClear(world_, place, runner.radius, tooOld ? 1 : kLongestSettling) ||
        !descent_.settle(place, runner.radius))
    {
        if (tooOld)
        {
            if (const auto other = release_.find([](const Eigen::Vector3d&) { return true; }))
            {
                runner.restart(runner.id, *other);
            }
        }
        return false;
    }
    if (tooOld)
    {
        freezeAt(runner, place);
        return true;
    }
    if ((place - runner.position).squaredNorm() > kLongestSettling * kLongestSettling)
    {
        return false;
    }
    for (const std::uint32_t k : runner.meeting)
    {
        const double contact = runner.radius + runners_[k].radius - kMostOverlap;
        if (!frozen_[k] && runner.yields &&
            (runners_[k].position - place).squaredNorm() < contact * contact)
        {
            runner.yields = runner.calmWindows < kPatience;
            return false;
        }
    }
    freezeAt(runner, place);
    return true;
}

void FastEngine::freezeAt(Runner& runner, const Eigen::Vector3d& place)
{
    world_.spheres.setPosition(runner.id, place);
    world_.freeze(runner.id);
    falls_.insert(place);
    release_.close(place, runner.radius);
    wakeAround(place);
}

void FastEngine::wakeAround(const Eigen::Vector3d& place)
{
    for (std::size_t k = 0; k < running_; ++k)
    {
        const double near = runners_[k].radius + 1 + 2 * Neighbourhood::kSkin;
        if ((runners_[k].position - place).squaredNorm() < near * near)
        {
            runners_[k].around.invalidate();
        }
    }
}

// Keeps the order of the others, and the memory of the frozen ones for spheres to come.
void FastEngine::forgetFrozen()
{
    std::size_t kept = 0;
    for (std::size_t k = 0; k < running_; ++k)
    {
        if (!frozen_[k])
        {
            std::swap(runners_[kept++], runners_[k]);
        }
    }
    running_ = kept;
    world_.forgetFrozen();
}

} // namespace frostfill

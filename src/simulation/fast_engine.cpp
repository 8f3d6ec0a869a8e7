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
constexpr double kNearRoom = 0.1; // that a runner may be moved out of a freezing one's place [r]
constexpr double kFarRoom = 1;    // the same for one that is overdue [r]
constexpr std::uint32_t kPatience = 8; // calm windows after which a sphere stops giving way
constexpr double kStillRunning = 0.2;  // share of a set that may run when the next one appears
constexpr double kFootprint = 0.1;     // share of the cross-section that a set covers by default

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
      threads_(world.scene.threads),
      encounters_(world, flight_, threads_, {world.scene.motion.restitution}),
      setSize_(spheresInSet(world)),
      ageLimit_(world.scene.freezing.setTimeLimit + 4 * std::sqrt(2 * world.height))
{
    if (!release_.any())
    {
        refuseTooLarge(world);
    }
    if (world.scene.discard.rule == DiscardRule::exact)
    {
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
    const auto few = static_cast<std::size_t>(kStillRunning * static_cast<double>(setSize_));
    if (running_ <= few && !releaseSet() && running_ == 0)
    {
        world_.full = world_.targetCount == 0 || world_.spheres.size() < world_.targetCount;
        world_.finished = true;
        if (discard_)
        {
            discard_->update({});
        }
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
    if (discard_)
    {
        const StageTimer timer(world_.times, Stage::discarding);
        discard_->updateWhenDue({runners_.data(), running_});
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
    // Free flight is analytic: with Motion::skip a sphere appears where it would touch first.
    const bool skip = world_.scene.motion.mode == Motion::skip;
    Eigen::Vector3d start;
    const auto suits = [&](const Eigen::Vector3d& place)
    {
        start = place;
        if (skip)
        {
            descent_.drop(start, 1);
        }
        return clearOfRunners(start);
    };
    while (world_.spheres.size() - before < wanted)
    {
        if (!release_.find(suits))
        {
            break;
        }
        const std::size_t inSet = world_.spheres.size() - before;
        const auto group =
            nextGroup_ + static_cast<std::uint32_t>(inSet / world_.scene.spheres.groupSize);
        const std::uint32_t id = world_.release(start, 1, group);
        if (running_ == runners_.size())
        {
            runners_.emplace_back();
        }
        runners_[running_++].restart(id, start);
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
        threads_.forEach(runners.size(),
                         [&](std::size_t i)
                         {
                             flight_.advance(runners[i], world_.dt);
                             runners[i].age += world_.dt;
                         });
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
        if (!frozen_[k])
        {
            frozen_[k] = tryFreeze(k);
        }
    }
    forgetFrozen();
}

bool FastEngine::tryFreeze(std::uint32_t index)
{
    Runner& runner = runners_[index];
    const bool tooOld = runner.age > ageLimit_;
    runner.yields = runner.yields && runner.calmWindows < kPatience && !tooOld;
    runner.around.ensure(world_, runner.position, runner.radius, 0);
    contactNormals(world_.surface, runner.around, runner.position, runner.radius, kContactGap,
                   runner.normals);
    const double missing = projectToFree({0, -1, 0}, runner.normals).norm();
    if (missing > kMostlyCarried && !tooOld)
    {
        return false;
    }
    Eigen::Vector3d place = runner.position;
    if (!descent_.settle(place, runner.radius, runner.around) && !tooOld)
    {
        return false;
    }
    const double way = (place - runner.position).squaredNorm();
    if (way > kLongestSettling * kLongestSettling && !tooOld)
    {
        return false;
    }
    freezeAt(runner, place);
    if (!makeRoom(index, tooOld ? kFarRoom : kNearRoom))
    {
        if (!tooOld)
        {
            world_.unfreezeLast();
            world_.spheres.setPosition(runner.id, runner.position);
            return false;
        }
        evict(index);
    }
    falls_.insert(place);
    release_.close(place, runner.radius);
    tellOthers(place, runner.radius);
    if (discard_)
    {
        discard_->addResting(runner.id);
    }
    return true;
}

void FastEngine::freezeAt(Runner& runner, const Eigen::Vector3d& place)
{
    world_.spheres.setPosition(runner.id, place);
    world_.freeze(runner.id);
}

// Moves every runner that the sphere just frozen overlaps to a clear place nearby. Returns false,
// and moves none, when one of them cannot be moved.
bool FastEngine::makeRoom(std::uint32_t index, double farthest)
{
    const Eigen::Vector3d place = world_.spheres.position(runners_[index].id);
    moved_.clear();
    for (std::uint32_t k = 0; k < running_; ++k)
    {
        Runner& other = runners_[k];
        const double contact = other.radius + runners_[index].radius;
        if (k == index || frozen_[k] || (other.position - place).squaredNorm() >= contact * contact)
        {
            continue;
        }
        Eigen::Vector3d clear = other.position;
        if (!moveClear(world_, clear, other.radius, farthest))
        {
            return false;
        }
        moved_.emplace_back(k, clear);
    }
    for (const auto& [k, clear] : moved_)
    {
        runners_[k].position = clear;
    }
    return true;
}

// The last resort, for a sphere that has been running for far too long and rests where others are:
// these appear again elsewhere, or are withdrawn when the object is full.
void FastEngine::evict(std::uint32_t index)
{
    const Eigen::Vector3d place = world_.spheres.position(runners_[index].id);
    for (std::uint32_t k = 0; k < running_; ++k)
    {
        Runner& other = runners_[k];
        const double contact = other.radius + runners_[index].radius;
        if (k == index || frozen_[k] || (other.position - place).squaredNorm() >= contact * contact)
        {
            continue;
        }
        Eigen::Vector3d clear = other.position;
        if (moveClear(world_, clear, other.radius, kFarRoom))
        {
            other.position = clear;
        }
        else if (const auto elsewhere =
                     release_.find([this](const Eigen::Vector3d& p) { return clearOfRunners(p); }))
        {
            other.restart(other.id, *elsewhere);
        }
        else
        {
            frozen_[k] = true; // not to be looked at any more
            const std::uint32_t renumbered = world_.withdraw(other.id);
            for (std::uint32_t other2 = 0; other2 < running_; ++other2)
            {
                if (runners_[other2].id == renumbered)
                {
                    runners_[other2].id = other.id;
                }
            }
        }
    }
}

bool FastEngine::clearOfRunners(const Eigen::Vector3d& place) const
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
}

void FastEngine::tellOthers(const Eigen::Vector3d& place, double radius)
{
    for (std::size_t k = 0; k < running_; ++k)
    {
        runners_[k].around.add(place, radius);
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

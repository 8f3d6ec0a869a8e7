// SPDX-License-Identifier: MIT
#include "simulation/engine/joint_rest_engine.hpp"

#include "base/timers.hpp"

#include <utility>

namespace frostfill
{

JointRestEngine::JointRestEngine(World& world, MakeFilling makeFilling)
    : world_(world), threads_(world.scene.threads), makeFilling_(std::move(makeFilling)),
      filling_(makeFilling_(world)), settling_(world, threads_)
{
}

void JointRestEngine::releaseAt(std::span<const PlacedSphere> spheres)
{
    filling_->releaseAt(spheres);
}

bool JointRestEngine::step()
{
    if (world_.clock.finished)
    {
        return false;
    }
    if (filling_)
    {
        return fill();
    }
    settle();
    return true;
}

bool JointRestEngine::fill()
{
    const bool advanced = filling_->step();
    if (!world_.clock.finished || world_.spheres.size() == settled_)
    {
        return advanced;
    }
    world_.clock.finished = false;
    world_.clock.full = false;
    world_.clock.inletsReached = false;
    filling_.reset();
    settling_.wakeAll();
    settling_.begin();
    world_.clock.settles = true;
    record_.open(world_, 0);
    return true;
}

void JointRestEngine::settle()
{
    bool over = false;
    {
        const StageTimer timer(world_.counts.times, Stage::settling);
        over = settling_.step();
    }
    if (over)
    {
        record_.close(world_);
        settled_ = world_.spheres.size();
        world_.clock.settles = false;
        filling_ = makeFilling_(world_);
    }
}

} // namespace frostfill

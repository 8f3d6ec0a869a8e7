// SPDX-License-Identifier: MIT
// How FastEngine freezes what carries one another: calm spheres that lie on each other as well as
// on what is at rest, as in a pile that has come to rest as a whole. They are frozen where they
// are, once their overlaps are taken apart.

#include "simulation/engine/fast_engine.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr double kStillShare = 0.75;    // of a set that is calm when it freezes whole
constexpr std::uint32_t kStillSet = 30; // windows for which it is to stay so

} // namespace

void FastEngine::freezeTogether(std::uint32_t stillWindows)
{
    const std::span<Runner> runners(runners_.data(), running_);
    for (Runner& runner : runners)
    {
        runner.member = false;
    }
    together_.clear();
    for (const std::uint32_t k : sleepy_)
    {
        if (!frozen_[k] && runners[k].stillWindows >= stillWindows)
        {
            together_.push_back(k);
            runners[k].member = true;
        }
    }
    carried_.keep(runners, together_);
    if (together_.empty())
    {
        return;
    }
    positionSolver_.separate(runners, together_);
    grid_.rebuild(runners);
    carried_.keep(runners, together_);
    for (const std::uint32_t k : together_)
    {
        // Those before may have made this one give way, or have failed to freeze.
        if (!frozen_[k] && carried_.carry(runners, runners[k]))
        {
            runners[k].carriedAt = runners[k].position;
            frozen_[k] = tryFreeze(k, true);
        }
        runners[k].member = false; // at rest or given up
    }
}

bool FastEngine::setIsWhole() const
{
    const std::size_t target = world_.targetCount;
    return inSet_ >= setSize_ || setSleeps_ || (target > 0 && world_.spheres.size() >= target);
}

// Where sets freeze whole: whether the newest is not all there yet or not all of it is calm. Once
// it is, or once something is overdue, its spheres freeze from below like any others.
bool FastEngine::waitForSet()
{
    const auto overdue = [this](const Runner& runner) { return runner.age > ageLimit_; };
    const auto end = runners_.begin() + static_cast<std::ptrdiff_t>(running_);
    const bool whole = setIsWhole() || !mayRelease_;
    const bool calm =
        static_cast<double>(sleepy_.size()) >= kStillShare * static_cast<double>(running_);
    stillSetWindows_ = whole && calm ? stillSetWindows_ + 1 : 0;
    if (!setSleeps_ &&
        (stillSetWindows_ >= kStillSet || std::any_of(runners_.begin(), end, overdue)))
    {
        setSleeps_ = true;
        for (Runner& runner : runners_)
        {
            runner.stillWindows = std::min(runner.stillWindows, 1u);
        }
    }
    return !setSleeps_;
}

} // namespace frostfill

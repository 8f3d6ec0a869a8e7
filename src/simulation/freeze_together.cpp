// SPDX-License-Identifier: MIT
// How FastEngine freezes what carries one another: calm spheres that lie on each other as well as
// on what is at rest, as in a pile that has come to rest as a whole. They are frozen where they
// are, once their overlaps are taken apart.

#include <simulation/fast_engine.hpp>

namespace frostfill
{

void FastEngine::freezeTogether(std::uint32_t calmWindows)
{
    const std::span<Runner> runners(runners_.data(), running_);
    for (Runner& runner : runners)
    {
        runner.member = false;
    }
    together_.clear();
    for (const std::uint32_t k : calm_)
    {
        if (!frozen_[k] && runners[k].calmWindows >= calmWindows)
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
    encounters_.separate(runners, together_);
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

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/solver/turns.hpp"

#include <algorithm>

namespace frostfill
{

void Turns::start()
{
    met_ = 0;
    ends_.assign(crowd_.strips().size(), 0);
    if (!crowd_.stripsTouch())
    {
        return;
    }
    done_.assign(crowd_.size(), 0);
    changes_.assign(crowd_.size(), 0);
    turnCount_.assign(crowd_.size(), 0);
    turns_.resize(crowd_.firstNear(crowd_.size()) + crowd_.size());
}

void Turns::meet()
{
    const std::size_t strips = crowd_.strips().size();
    if (!crowd_.stripsTouch())
    {
        return;
    }
    const std::size_t before = met_.fetch_add(1, std::memory_order_acq_rel);
    const std::size_t all = (before / strips + 1) * strips;
    crowd_.threads().waitUntil([&] { return met_.load(std::memory_order_acquire) >= all; });
}

void Turns::findTurns(std::size_t strip)
{
    if (crowd_.stripsTouch())
    {
        crowd_.forEachMember(strip, [this](std::uint32_t slot) { findTurnsOf(slot); });
    }
}

// Of those who may be changed from two strips only.
void Turns::findTurnsOf(std::uint32_t slot)
{
    Turn* next = turns_.data() + crowd_.firstNear(slot) + slot;
    const auto add = [&](std::uint32_t changed)
    {
        if (crowd_.isShared(changed))
        {
            *next++ = turnOf(slot, changed);
            ++turnCount_[slot];
        }
    };
    add(slot);
    for (const Crowd::Near& near : crowd_.near(slot))
    {
        if (near.isLower != 0)
        {
            add(near.slot);
        }
    }
}

// A sphere's own turn precedes those of its neighbours above it.
Turns::Turn Turns::turnOf(std::uint32_t slot, std::uint32_t changed) const
{
    Turn turn = {changed, 0, 1};
    const std::uint32_t rank = crowd_.rank(slot);
    for (const Crowd::Near& near : crowd_.near(changed))
    {
        if (near.isLower == 0)
        {
            ++turn.all;
            turn.ordinal += crowd_.rank(near.slot) < rank ? 1 : 0;
        }
    }
    turn.ordinal += changed == slot ? 0 : 1;
    return turn;
}

void Turns::awaitForeign(std::uint32_t slot, bool lower, std::uint32_t sweep)
{
    for (const Crowd::Near& near : crowd_.near(slot))
    {
        if (near.isForeign != 0 && (near.isLower != 0) == lower)
        {
            crowd_.threads().waitUntil(
                [&] { return at(done_[near.slot]).load(std::memory_order_acquire) >= sweep; });
        }
    }
}

// Another one that is in a later sweep has heard that this one was not the last.
bool Turns::isLast(std::size_t strip, std::uint32_t sweep, bool goesOn)
{
    if (crowd_.strips().size() == 1)
    {
        return !goesOn;
    }
    at(ends_[strip]).store(2 * sweep + (goesOn ? 1 : 0), std::memory_order_release);
    if (goesOn)
    {
        return false;
    }
    return std::all_of(ends_.begin(), ends_.end(),
                       [&](std::uint32_t& other)
                       {
                           std::uint32_t end = 0;
                           crowd_.threads().waitUntil(
                               [&]
                               {
                                   end = at(other).load(std::memory_order_acquire);
                                   return end >= 2 * sweep;
                               });
                           return end == 2 * sweep;
                       });
}

void Turns::awaitOwnTurns(std::uint32_t slot, std::uint32_t rounds)
{
    const std::uint32_t all = rounds * turns(slot).front().all;
    crowd_.threads().waitUntil(
        [&] { return at(changes_[slot]).load(std::memory_order_acquire) == all; });
}

void Turns::awaitTurns(std::uint32_t slot, std::uint32_t round)
{
    for (const Turn& turn : turns(slot))
    {
        const std::uint32_t before = round * turn.all + turn.ordinal;
        crowd_.threads().waitUntil(
            [&] { return at(changes_[turn.slot]).load(std::memory_order_acquire) == before; });
    }
}

void Turns::endTurns(std::uint32_t slot)
{
    for (const Turn& turn : turns(slot))
    {
        const auto changes = at(changes_[turn.slot]);
        changes.store(changes.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    }
}

} // namespace frostfill

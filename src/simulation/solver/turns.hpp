// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/solver/crowd.hpp"

#include <atomic>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// The sweep in which velocities are taken from those below, and the first of those of positions.
inline constexpr std::uint32_t kSweepOfVelocities = 1;
inline constexpr std::uint32_t kFirstOfPositions = 2;

/// Lets the strips of a crowd be taken at the same time with the bits of one member after another.
/// Members of one strip follow each other anyhow; a member that may touch one of another strip
/// waits until that one has had as many turns as it would have had by then: those below it in the
/// same sweep, those above it in the one before. So the wait ends: of all turns that are due, the
/// one that would come first waits for nobody. Graph colouring, which Box3D uses for this, would
/// change the order, and with it the bits and the way in which the floor's reaction climbs a pile.
class Turns
{
public:
    explicit Turns(const Crowd& crowd) : crowd_(crowd) {}

    /// To be called for each crowd that is gathered, before its strips are taken.
    void start();
    /// Returns once all strips have come here, if some of them touch.
    void meet();

    // Sweeps, numbered from 1, in which a member's turn reads those nearby and changes only itself.

    /// Returns once those below have had their turn.
    void awaitLower(std::uint32_t slot, std::uint32_t sweep)
    {
        if (crowd_.isShared(slot))
        {
            awaitForeign(slot, true, sweep);
        }
    }
    /// The same for those above: they are to be read as this sweep has left them.
    void awaitUpper(std::uint32_t slot, std::uint32_t sweep)
    {
        if (crowd_.isShared(slot))
        {
            awaitForeign(slot, false, sweep);
        }
    }
    void endTurn(std::uint32_t slot, std::uint32_t sweep)
    {
        if (crowd_.isShared(slot))
        {
            at(done_[slot]).store(sweep, std::memory_order_release);
        }
    }
    /// To be called at the end of each sweep but the last that there can be: whether no strip goes
    /// on. Returns at once in one that does.
    [[nodiscard]] bool isLast(std::size_t strip, std::uint32_t sweep, bool goesOn);

    // Rounds, numbered from 0, in which a member's turn changes itself and those nearby below it.

    /// To be called in each strip before its rounds, and for all strips before the first round.
    void findTurns(std::size_t strip);
    /// Whether a turn of this member may be waited for.
    [[nodiscard]] bool isAwaited(std::uint32_t slot) const
    {
        return crowd_.stripsTouch() && (crowd_.isShared(slot) || turnCount_[slot] > 0);
    }
    void awaitRound(std::uint32_t slot, std::uint32_t round)
    {
        if (crowd_.stripsTouch())
        {
            awaitTurns(slot, round);
        }
    }
    void endRound(std::uint32_t slot)
    {
        if (crowd_.stripsTouch())
        {
            endTurns(slot);
        }
    }
    /// Returns once so many rounds are over for this member.
    void awaitRounds(std::uint32_t slot, std::uint32_t rounds)
    {
        if (crowd_.isShared(slot))
        {
            awaitOwnTurns(slot, rounds);
        }
    }

private:
    /// A member's place in the turns of a round in which somebody's part is changed.
    struct Turn
    {
        std::uint32_t slot;    ///< of who is changed
        std::uint32_t ordinal; ///< of this turn, among those of a round that change it
        std::uint32_t all;     ///< such turns
    };
    [[nodiscard]] static std::atomic_ref<std::uint32_t> at(std::uint32_t& count)
    {
        return std::atomic_ref<std::uint32_t>(count);
    }
    void findTurnsOf(std::uint32_t slot);
    void awaitForeign(std::uint32_t slot, bool lower, std::uint32_t sweep);
    void awaitOwnTurns(std::uint32_t slot, std::uint32_t rounds);
    void awaitTurns(std::uint32_t slot, std::uint32_t round);
    void endTurns(std::uint32_t slot);
    [[nodiscard]] Turn turnOf(std::uint32_t slot, std::uint32_t changed) const;
    [[nodiscard]] std::span<const Turn> turns(std::uint32_t slot) const
    {
        return {turns_.data() + crowd_.firstNear(slot) + slot, turnCount_[slot]};
    }

    const Crowd& crowd_;
    std::atomic<std::size_t> met_ = 0; ///< comings of strips
    /// By strip: twice the last sweep that it has ended, and one more if it goes on.
    std::vector<std::uint32_t> ends_;
    // By slot.
    std::vector<std::uint32_t> done_;    ///< the last sweep in which it has had its turn
    std::vector<std::uint32_t> changes_; ///< turns that have changed it in rounds
    std::vector<std::uint32_t> turnCount_;
    std::vector<Turn> turns_;
};

} // namespace frostfill

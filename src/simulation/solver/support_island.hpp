// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/motion/free_flight.hpp"
#include "simulation/solver/broad_phase.hpp"

#include <vector>

namespace frostfill
{

/// The island of runners that carry one another, as in a pile that has come to rest: the largest
/// set of which each is carried by what is at rest and by the others in it.
class SupportIsland
{
public:
    SupportIsland(const RunningSpheres& running, FreeFlight& flight, const BroadPhase& pairs,
                  Threads& threads)
        : running_(running), flight_(flight), pairs_(pairs), threads_(threads)
    {
    }

    /// Of these runners, given by row, leaves those that carry one another, who are its members
    /// from then on. `pairs` is up to date.
    void keep(std::vector<std::uint32_t>& members);

    /// Whether what is at rest and members carry the runner.
    [[nodiscard]] bool carry(std::uint32_t row);
    /// The runner is no member any more.
    void dismiss(std::uint32_t row) { member_[row] = 0; }

private:
    /// Finds what is at rest and touches it.
    void touch(std::uint32_t row);
    /// After touch(): whether that and members carry it. Moves no sphere.
    [[nodiscard]] bool isCarriedToo(std::uint32_t row);

    const RunningSpheres& running_;
    FreeFlight& flight_;
    const BroadPhase& pairs_;
    Threads& threads_;
    std::vector<char> member_;        ///< by row
    std::vector<char> falls_;         ///< by row, of members
    std::vector<std::uint32_t> gone_; ///< rows
};

} // namespace frostfill

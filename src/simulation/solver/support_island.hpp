// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/motion/free_flight.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// The island of runners that carry one another, as in a pile that has come to rest: the largest
/// set of which each is carried by what is at rest and by the others in it.
class SupportIsland
{
public:
    SupportIsland(const FreeFlight& flight, Threads& threads) : flight_(flight), threads_(threads)
    {
    }

    /// Of those with Runner::member, takes it from those that are not carried. `members` lists
    /// them; Runner::nearby of each is up to date.
    void keep(std::span<Runner> runners, std::vector<std::uint32_t>& members);

    /// Whether what is at rest and members carry the runner.
    [[nodiscard]] bool carry(std::span<const Runner> runners, Runner& runner) const;

private:
    /// Finds what is at rest and touches it.
    void touch(Runner& runner) const;
    /// After touch(): whether that and members carry it. Moves no runner.
    [[nodiscard]] bool isCarriedToo(std::span<const Runner> runners, Runner& runner) const;

    const FreeFlight& flight_;
    Threads& threads_;
    std::vector<std::uint32_t> gone_; ///< scratch of keep
};

} // namespace frostfill

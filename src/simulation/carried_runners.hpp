// SPDX-License-Identifier: MIT
#pragma once

#include <simulation/flight.hpp>
#include <simulation/parallel.hpp>

#include <span>
#include <vector>

namespace frostfill
{

/// Which runners carry one another, as in a pile that has come to rest: the largest set of which
/// each is carried by what is at rest and by the others in it.
class CarriedRunners
{
public:
    struct Settings
    {
        double gap = 0.005;      ///< below which a contact carries [own radius]
        double uncarried = 0.05; ///< share of the weight that may remain
    };

    CarriedRunners(const Flight& flight, Threads& threads, const Settings& settings)
        : flight_(flight), threads_(threads), settings_(settings)
    {
    }

    /// Of those with Runner::member, takes it from those that are not carried. `members` lists
    /// them; their lists of meetings are up to date.
    void keep(std::span<Runner> runners, std::vector<std::uint32_t>& members);

    /// Whether what is at rest and members carry the runner.
    [[nodiscard]] bool carry(std::span<const Runner> runners, Runner& runner) const;

private:
    const Flight& flight_;
    Threads& threads_;
    Settings settings_;
    std::vector<std::uint32_t> gone_; ///< scratch of keep
};

} // namespace frostfill

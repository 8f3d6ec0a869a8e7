// SPDX-License-Identifier: MIT
// Room: when a sphere sleeps, when it wakes, and what a set is. It knows the solver and what
// follows spheres at rest, but no schedule.
#pragma once

#include "simulation/freezing/freezing_rule.hpp"
#include "simulation/world/set_recorder.hpp"

namespace frostfill
{

/// Keeps the sets: which one is the newest, when spheres are due to appear, and how many. When they
/// freeze is the freezing rule's to say.
class SetSchedule
{
public:
    SetSchedule(World& world, double ageLimit);

    /// Whether a set, or the rest of one, is due to appear.
    [[nodiscard]] bool isDue(std::size_t running) const;
    /// Spheres that are to appear now. A set begins, unless the newest lacks some.
    [[nodiscard]] std::size_t startSearch(std::size_t running);
    /// The group of the n-th sphere that is found in this search, n from 0.
    [[nodiscard]] std::uint32_t groupOf(std::size_t n) const;
    /// To be called with the number of spheres that have appeared.
    void endSearch(std::size_t found);
    /// Those that the user has placed, a set of their own, have appeared.
    void placed(std::size_t spheres);

    /// A window is over: see FreezingPart::select. Spheres are due again from then on.
    void endWindow(std::span<RestWatch> running, std::vector<std::uint32_t>& sleepy);

    /// See FreezingPart::keepsSets.
    [[nodiscard]] bool keepsSets() const { return rule_->keepsSets(); }

    /// Begins the record of a set of so many spheres; that of the set before ends.
    void openRecord(std::size_t spheres);
    /// Takes one step's milliseconds between spheres into the record. Walls are met in flight.
    void observeSolver(double sphereSphereMs) { record_.observe(sphereSphereMs, 0); }
    void closeRecord() { record_.close(world_); }

private:
    void startGroups();
    [[nodiscard]] SetProgress progress(std::size_t running) const;

    World& world_;
    std::unique_ptr<FreezingPart> rule_;
    SetRecorder record_;
    double ageLimit_;
    std::size_t groupSize_;
    std::size_t size_;         ///< spheres of a whole set
    std::size_t appeared_ = 0; ///< of the newest set
    std::uint32_t nextGroup_ = 0;
    std::uint32_t windows_ = 0;
    bool noRoom_ = false; ///< a search that found nothing is not repeated before runners move on
};

} // namespace frostfill

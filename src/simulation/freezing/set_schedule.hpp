// SPDX-License-Identifier: MIT
// Room: when a sphere sleeps, when it wakes, and what a set is. It knows the solver and what
// follows spheres at rest, but no schedule.
#pragma once

#include "simulation/world/set_recorder.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// What is watched of a running sphere, to tell when it comes to rest.
struct RestWatch
{
    Eigen::Vector3d start = Eigen::Vector3d::Zero(); ///< position at the window's start
    double age = 0; ///< since its release, or something came to rest beside it [sqrt(r/g)]
    std::uint32_t stillWindows = 0; ///< in a row in which it hardly moved
};

/// Keeps the sets: which one is the newest, when spheres are due to appear, and how many; and the
/// freezing rule of the scene. By the rule one by one each calm sphere may freeze. By the rule by
/// set a set settles and freezes as a whole: spheres that find no room are added to the newest set,
/// and piles settle slowly and densely. Once that set is complete and most of it has been calm for
/// long, or something is overdue, its spheres freeze from below like any others.
///
/// By either rule a sphere freezes only where something carries it, and one that is overdue
/// wherever it is.
class SetSchedule
{
public:
    /// `ageLimit`: RestWatch::age after which a sphere is overdue [sqrt(r/g)].
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

    /// A window is over. Takes those out of `sleepy` that are to run on: rows of `running` whose
    /// spheres are calm or overdue, the lowest sphere first. Spheres are due again from then on.
    void endWindow(std::span<RestWatch> running, std::vector<std::uint32_t>& sleepy);

    /// Whether sets settle and freeze as a whole.
    [[nodiscard]] bool keepsSets() const { return keepsSets_; }

    [[nodiscard]] SetRecorder& record() { return record_; }

private:
    void startGroups();
    [[nodiscard]] bool isComplete() const;
    [[nodiscard]] bool mayAppearBeside(std::size_t running) const;

    World& world_;
    bool keepsSets_;
    SetRecorder record_;
    double ageLimit_;
    std::size_t groupSize_;
    std::size_t size_;         ///< spheres of a whole set
    std::size_t appeared_ = 0; ///< of the newest set
    std::uint32_t nextGroup_ = 0;
    std::uint32_t windows_ = 0;
    bool sleeps_ = false;            ///< the newest set freezes
    std::uint32_t stillWindows_ = 0; ///< in a row in which most of it was calm
    bool noRoom_ = false; ///< a search that found nothing is not repeated before runners move on
};

} // namespace frostfill

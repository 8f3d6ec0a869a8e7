// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/freezing/overlap_resolver.hpp"
#include "simulation/freezing/set_schedule.hpp"
#include "simulation/freezing/support_at_rest.hpp"
#include "simulation/freezing/tolerances.hpp"
#include "simulation/motion/drop_and_roll.hpp"
#include "simulation/motion/free_flight.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/solver/position_solver.hpp"
#include "simulation/solver/support_island.hpp"

#include <optional>
#include <vector>

namespace frostfill
{

/// Puts runners to sleep: each sphere by itself, as soon as it is calm and what is at rest carries
/// it. It is taken to the nearest place below at which its contacts carry it, so it neither
/// overlaps anything nor hangs in the air. Where more than a layer runs, islands of spheres that
/// carry one another freeze together, where they are.
class Freezer
{
public:
    /// Everything given outlives this; the release may be replaced. `ageLimit`: see SetSchedule.
    Freezer(World& world, SphereGrid& grid, const std::unique_ptr<ReleasePart>& release,
            FreeFlight& flight, PositionSolver& solver, Threads& threads, double ageLimit);

    /// To be called in each step for each runner after its flight, on any thread: it is older by
    /// `dt`.
    void age(std::uint32_t row, double dt) { watch_[row].age += dt; }
    /// Windows begin where the runners are now.
    void startWindow();
    /// To be called at the end of each window.
    void freeze(SetSchedule& sets);

private:
    /// One that has come to rest in this window.
    struct Frozen
    {
        std::uint32_t atRest; ///< its row there
        double age;
        bool tooOld;
        bool together;
    };

    void watchRow(std::uint32_t row);
    void findSleepy();
    void freezeTogether(std::uint32_t stillWindows);
    void freezeOneByOne();
    void findPlaces();
    void findPlace(std::uint32_t row);
    void tryFreeze(std::uint32_t row, bool insist = false);
    void wakeUncarried();
    /// Tells the runners nearby that a sphere has come to rest.
    void tell(const Eigen::Vector3d& place, double radius);
    [[nodiscard]] bool isOverdue(std::uint32_t row) const { return watch_[row].age > ageLimit_; }
    /// More than a layer of runners is a pile, in which spheres carry each other.
    [[nodiscard]] bool isPile() const { return static_cast<double>(running_.size()) > layer_; }

    World& world_;
    RunningSpheres& running_;
    SphereGrid& grid_;
    const std::unique_ptr<ReleasePart>& release_;
    FreeFlight& flight_;
    PositionSolver& solver_;
    Threads& threads_;
    DropAndRoll dropAndRoll_;
    SupportIsland island_;
    OverlapResolver resolver_;
    SupportAtRest support_;
    double ageLimit_;
    double layer_; ///< spheres that cover the object's cross-section
    RunningColumn<RestWatch> watch_;
    // By row, at the end of a window.
    std::vector<std::optional<Eigen::Vector3d>> carriedAt_; ///< where what is at rest carries it
    std::vector<char> stale_; ///< something has come to rest, or has moved, since that was found
    std::vector<std::uint32_t> sleepy_;   ///< runners to be frozen, the lowest first
    std::vector<std::uint32_t> together_; ///< those of an island, the lowest first
    std::vector<Frozen> frozen_;
};

} // namespace frostfill

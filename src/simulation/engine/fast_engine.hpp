// SPDX-License-Identifier: MIT
// Room: the schedules of a run, made of the parts in the other rooms. One step of an engine
// reads as a table of contents.
#pragma once

#include "base/threads.hpp"
#include "simulation/freezing/freezer.hpp"
#include "simulation/freezing/set_schedule.hpp"
#include "simulation/freezing/waker.hpp"
#include "simulation/motion/drop_and_roll.hpp"
#include "simulation/motion/free_flight.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/solver/position_solver.hpp"
#include "simulation/world/world.hpp"

#include <optional>

namespace frostfill
{

/// Our own engine: the paper's Algorithm 1 with better parts. Sets appear as in the paper; each
/// sphere is frozen by itself as soon as it is calm and what is at rest carries it. This class is
/// the schedule; what is done in each of its steps, its parts do.
class FastEngine : public Engine
{
public:
    explicit FastEngine(World& world);
    void releaseAt(std::span<const PlacedSphere> spheres) override;
    bool step() override;

private:
    void releaseWhenDue();
    [[nodiscard]] bool anythingMoves();
    void advance();
    void solve();
    void freezeAndWake();
    void finish();

    [[nodiscard]] std::size_t release(std::size_t wanted);
    void countTests();
    void observeEnergy();

    World& world_;
    RunningSpheres& running_;
    Threads threads_;
    SphereGrid grid_; ///< of the runners
    std::unique_ptr<ReleasePart> release_;
    FreeFlight flight_;
    DropAndRoll dropAndRoll_;
    SetSchedule sets_;
    PositionSolver solver_;
    Freezer freezer_;
    Waker waker_;
    std::optional<double> energy_; ///< of the runners, while they are as the last step left them
    std::uint32_t windowSteps_ = 1;
    std::uint32_t stepsInWindow_ = 0;
};

} // namespace frostfill

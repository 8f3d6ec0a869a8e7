// SPDX-License-Identifier: MIT
// Room: the schedules of a run, made of the parts in the other rooms. One step of an engine
// reads as a table of contents.
#pragma once

#include "base/threads.hpp"
#include "simulation/contact/runner.hpp"
#include "simulation/discard/exact_discard.hpp"
#include "simulation/motion/drop_and_roll.hpp"
#include "simulation/motion/fall_index.hpp"
#include "simulation/motion/free_flight.hpp"
#include "simulation/release/releases.hpp"
#include "simulation/solver/position_solver.hpp"
#include "simulation/solver/support_island.hpp"
#include "simulation/world/set_recorder.hpp"
#include "simulation/world/world.hpp"

#include <array>
#include <optional>
#include <vector>

namespace frostfill
{

/// Our own engine: the paper's Algorithm 1 with better parts. Sets appear as in the paper; each
/// sphere is frozen by itself as soon as it is calm and what is at rest carries it.
class FastEngine : public Engine
{
public:
    explicit FastEngine(World& world);
    void releaseAt(std::span<const PlacedSphere> spheres) override;
    bool step() override;

private:
    void finish();
    bool releaseSet();
    void start(const Eigen::Vector3d& place, double radius, std::uint32_t group);
    void openSet(std::size_t spheres);
    [[nodiscard]] double runningEnergy() const;
    void advance();
    [[nodiscard]] double ageing(const Runner& runner) const;
    [[nodiscard]] bool setIsWhole() const;
    [[nodiscard]] bool waitForSet();
    void freezeSleepy();
    void findSleepy();
    /// More than a layer of runners is a pile, in which spheres carry each other.
    [[nodiscard]] bool isPile() const { return static_cast<double>(running_) > layer_; }
    void freezeTogether(std::uint32_t stillWindows);
    void findPlace(Runner& runner) const;
    bool followObject();
    void renewSites();
    void wakeWhenDue();
    void wake();
    [[nodiscard]] std::array<Eigen::Vector3d, 8> directionsAtCorners() const;
    [[nodiscard]] bool isSupported(std::uint32_t id);
    void unfreeze(std::uint32_t id);
    [[nodiscard]] bool tryFreeze(std::uint32_t index, bool insist = false);
    void findOverlapped(std::uint32_t index, const Eigen::Vector3d& place);
    [[nodiscard]] bool makeRoom(const PlacedSphere& resting, double farthest);
    void put(std::uint32_t index, const Eigen::Vector3d& place);
    void evictOverlapped();
    void withdraw(Runner& runner);
    [[nodiscard]] bool clearOfRunners(const Eigen::Vector3d& place, double radius) const;
    void tellOthers(const Eigen::Vector3d& place, double radius);
    void forgetFrozen();

    World& world_;
    Threads threads_;
    FallIndex falls_;
    std::optional<Releases> release_;
    DropAndRoll dropAndRoll_;
    FreeFlight flight_;
    RunnerGrid grid_; ///< of the runners, as they lay at the last rebuild
    PositionSolver positionSolver_;
    SupportIsland carried_;
    std::unique_ptr<ExactDiscard> discard_; ///< empty when nothing is to be discarded
    SetRecorder clock_;
    std::vector<Runner> runners_; ///< the first running_ are in use; the others keep their memory
    std::size_t running_ = 0;
    std::optional<double> energy_; ///< of the runners, while they are as the last step left them
    std::vector<std::uint32_t> sleepy_;     ///< runners to be frozen, the lowest first
    std::vector<bool> frozen_;              ///< by runner, in this step
    std::vector<std::uint32_t> overlapped_; ///< by the sphere that is being frozen, ascending
    std::vector<Eigen::Vector3d> moved_;    ///< where makeRoom puts them
    std::vector<std::uint32_t> together_;   ///< runners to be frozen at once, the lowest first
    std::uint32_t windowSteps_ = 1;
    std::uint32_t stepsInWindow_ = 0;
    std::uint32_t windows_ = 0;
    bool mayRelease_ = true;
    std::uint32_t nextGroup_ = 0;
    std::size_t setSize_ = 0;
    std::size_t inSet_ = 0;  ///< spheres of the newest set so far; only where sets freeze whole
    bool setSleeps_ = false; ///< and so it freezes
    double layer_ = 0;       ///< spheres that cover the object's cross-section
    std::uint32_t stillSetWindows_ = 0; ///< in a row in which most of it was calm
    double ageLimit_ = 0;
    bool moving_ = false;      ///< the object moves, or what that let go still runs
    bool sitesAreNew_ = false; ///< since the object stands still again
    bool motionIsOver_ = false;
    std::array<Eigen::Vector3d, 8> lookedAt_; ///< the pull's direction at the box's corners when
                                              ///< all at rest were last looked at
    std::vector<Eigen::Vector3d> normals_;    ///< scratch of isSupported
};

} // namespace frostfill

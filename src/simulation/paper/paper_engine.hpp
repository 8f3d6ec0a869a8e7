// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/paper/algorithm1.hpp"
#include "simulation/paper/rest_monitor.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/world/set_recorder.hpp"
#include "simulation/world/world.hpp"

namespace frostfill
{

/// The paper's method, whole: sets of groups appear, run by Euler's method and Algorithm 1, come to
/// rest, are frozen every so many sets, and discards follow each freezing.
class PaperEngine : public Engine
{
public:
    explicit PaperEngine(World& world);
    void releaseAt(std::span<const PlacedSphere> spheres) override;
    bool step() override;

private:
    bool startNextSet();
    bool releaseSet();
    void startSet(std::size_t spheres);
    [[nodiscard]] bool clearOfRunning(const Eigen::Vector3d& place, double radius) const;
    void freezeAndDiscard();
    void integrate();
    void collide();
    void limitPushes();
    void observeRest();
    [[nodiscard]] bool isLost(std::uint32_t row) const;

    World& world_;
    RunningSpheres& running_;
    std::unique_ptr<SphereSearchPart> spheres_;
    std::unique_ptr<PolygonSearchPart> polygons_;
    Algorithm1 algorithm1_;
    Threads threads_{1};
    std::unique_ptr<ReleasePart> release_;
    RestMonitor rest_;
    SetRecorder clock_;

    bool setIsOver_ = true;        ///< the newest set has come to rest, or there is none yet
    std::uint32_t setsAtRest_ = 0; ///< since the last freezing
    std::uint32_t nextGroup_ = 0;
    std::size_t firstFrozen_ = 0; ///< first sphere of group FFG
    double setTime_ = 0;          ///< since the newest set appeared
    double setTimeLimit_ = 0;
    double fallEnergy_ = 0;                  ///< of all that runs, through the object's height
    std::vector<Eigen::Vector3d> before_;    ///< running centres before the step
    std::vector<Eigen::Vector3d> predicted_; ///< after integration
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/paper/algorithm1.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/world/running_spheres.hpp"
#include "simulation/world/set_recorder.hpp"
#include "simulation/world/world.hpp"

#include <cstdint>
#include <vector>

namespace frostfill
{

/// Tells when all running spheres have come to rest: over a whole window of steps each has touched
/// something and none has been farther than a tolerance from where it was at the window's start. A
/// speed alone would call a sphere at the top of its bounce at rest.
class RestMonitor
{
public:
    /// `windowSteps` >= 1; `tolerance` is a distance [r].
    RestMonitor(std::uint32_t windowSteps, double tolerance)
        : windowSteps_(windowSteps), tolerance_(tolerance)
    {
    }

    /// Starts a new window.
    void restart(const RunningSpheres& running)
    {
        step_ = 0;
        start_.assign(running.position.all().begin(), running.position.all().end());
        moved_.assign(start_.size(), false);
        touchedInWindow_.assign(start_.size(), false);
    }

    /// Takes in one step; `touched` by row. Returns true when the step ends a window in which all
    /// were at rest. Spheres for which `ignored(row)` holds do not count.
    template <class Ignored>
    bool observe(const RunningSpheres& running, const std::vector<bool>& touched, Ignored&& ignored)
    {
        const double limit = tolerance_ * tolerance_;
        for (std::uint32_t k = 0; k < start_.size(); ++k)
        {
            moved_[k] = moved_[k] || (running.position[k] - start_[k]).squaredNorm() > limit;
            touchedInWindow_[k] = touchedInWindow_[k] || touched[k];
        }
        if (++step_ < windowSteps_)
        {
            return false;
        }
        bool atRest = true;
        for (std::uint32_t k = 0; k < start_.size() && atRest; ++k)
        {
            atRest = (!moved_[k] && touchedInWindow_[k]) || ignored(k);
        }
        restart(running);
        return atRest;
    }

private:
    std::uint32_t windowSteps_;
    double tolerance_;
    std::uint32_t step_ = 0;
    std::vector<Eigen::Vector3d> start_;
    std::vector<bool> moved_;
    std::vector<bool> touchedInWindow_;
};

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

/// PAPER, equation 3: advances past every group whose spheres all lie more than `epsilon` below all
/// spheres of the last frozen group, and discards its spheres. A heuristic: height says nothing
/// about the pocket that a sphere is in. `firstFrozen` is the id of the first sphere of group FFG,
/// `frozenEnd` the id after the last frozen sphere. Returns the new firstFrozen.
[[nodiscard]] std::size_t discardByHeight(World& world, std::size_t firstFrozen,
                                          std::size_t frozenEnd, double epsilon);

/// PAPER, 1.2: discards polygons that are covered: from each of the three vertices the ray along
/// the vertex normal, into the object, meets a sphere at rest whose gap to the polygon is at most
/// `closeness`. A heuristic: the polygon may be within reach between its vertices.
/// Returns how many polygons were discarded.
std::size_t discardCoveredPolygons(World& world, double closeness);

} // namespace frostfill

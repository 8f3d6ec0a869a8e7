// SPDX-License-Identifier: MIT
#pragma once

#include "lab/pouring.hpp"

#include <limits>
#include <utility>

namespace frostfill
{

/// Tells when spheres have come to rest by the stop rule of all engines.
class RestDetector
{
public:
    /// At the end of each window: whether nearly all have hardly moved in it.
    [[nodiscard]] bool look(std::vector<Eigen::Vector3d> now)
    {
        std::size_t calm = 0;
        last_.resize(now.size(),
                     Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()));
        for (std::size_t k = 0; k < now.size(); ++k)
        {
            calm += (now[k] - last_[k]).squaredNorm() < kPeerStill * kPeerStill ? 1 : 0;
        }
        last_ = std::move(now);
        return static_cast<double>(calm) >= kPeerStillShare * static_cast<double>(last_.size());
    }

private:
    std::vector<Eigen::Vector3d> last_;
};

/// Pours, steps and looks until all spheres are at rest or a limit is reached. `Bodies` has
///     void addSphere(const Eigen::Vector3d& place);   // at rest
///     void step();                                    // exactly one, of the length `step`
///     std::size_t size() const;                       // spheres so far
///     std::vector<Eigen::Vector3d> places();          // their centres
///     double seconds() const;                         // of processor time
///     void end();                                     // only `seconds` is called after it
template <typename Bodies>
[[nodiscard]] PeerResult runRigidBodies(const PeerTask& task, double step, Bodies&& bodies)
{
    PeerResult result;
    RestDetector watch;
    Pouring pouring(task);
    double nextLook = 0;
    double nextPour = 0;
    while (!result.atRest && result.simulated < task.timeLimit &&
           bodies.seconds() < task.secondsLimit)
    {
        if (bodies.size() < task.count && result.simulated >= nextPour)
        {
            for (const Eigen::Vector3d& place : pouring.next(bodies.places()))
            {
                bodies.addSphere(place);
            }
            nextPour = result.simulated + kPeerPourEvery;
        }
        bodies.step();
        result.simulated += step;
        if (bodies.size() == task.count && result.simulated >= nextLook)
        {
            result.atRest = watch.look(bodies.places());
            nextLook = result.simulated + kPeerWindow;
        }
    }
    result.places = bodies.places();
    bodies.end();
    result.seconds = bodies.seconds();
    return result;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "base/processor_time.hpp"
#include "study/peers/pouring.hpp"
#include "study/peers/rest_detector.hpp"

namespace frostfill
{

/// What all engines of rigid bodies do alike: pour, step and look until all spheres are at rest or
/// a limit is reached. `Bodies` is made of a task and has
///     void addSphere(const Eigen::Vector3d& place);   // at rest
///     void step(double dt);                           // exactly one
///     std::size_t size() const;                       // spheres so far
///     std::vector<Eigen::Vector3d> places() const;    // their centres
template <typename Bodies>
[[nodiscard]] PeerResult runRigidBodies(const PeerTask& task, double step)
{
    const ProcessorClock clock; // making the bodies counts
    Bodies bodies(task);
    PeerResult result;
    RestDetector watch;
    Pouring pouring(task);
    double nextLook = 0;
    double nextPour = 0;
    while (!result.atRest && result.simulated < task.timeLimit &&
           clock.seconds() < task.secondsLimit)
    {
        if (bodies.size() < task.count && result.simulated >= nextPour)
        {
            for (const Eigen::Vector3d& place : pouring.next(bodies.places()))
            {
                bodies.addSphere(place);
            }
            nextPour = result.simulated + kPeerPourEvery;
        }
        bodies.step(step);
        result.simulated += step;
        if (bodies.size() == task.count && result.simulated >= nextLook)
        {
            result.atRest = watch.look(bodies.places());
            nextLook = result.simulated + kPeerWindow;
        }
    }
    result.seconds = clock.seconds();
    result.places = bodies.places();
    return result;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "base/processor_time.hpp"
#include "study/peers/pouring.hpp"
#include "study/peers/rest_detector.hpp"

namespace frostfill
{

/// What all engines of rigid bodies do alike: pour, step and look until all spheres are at rest or
/// a limit is reached. `Bodies` is made of a task and of `more`, and has
///     void addSphere(const Eigen::Vector3d& place);   // at rest
///     void step(double dt);                           // exactly one
///     std::size_t size() const;                       // spheres so far
///     std::vector<Eigen::Vector3d> places() const;    // their centres
/// and, where it is not this process that works,
///     double seconds() const;                         // of processor time
///     void end();                                     // only `seconds` is called after it
template <typename Bodies, typename... More>
[[nodiscard]] PeerResult runRigidBodies(const PeerTask& task, double step, const More&... more)
{
    const ProcessorClock clock; // making the bodies counts
    Bodies bodies(task, more...);
    const auto seconds = [&]
    {
        if constexpr (requires { bodies.seconds(); })
        {
            return bodies.seconds();
        }
        else
        {
            return clock.seconds();
        }
    };
    PeerResult result;
    RestDetector watch;
    Pouring pouring(task);
    double nextLook = 0;
    double nextPour = 0;
    while (!result.atRest && result.simulated < task.timeLimit && seconds() < task.secondsLimit)
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
    result.places = bodies.places();
    if constexpr (requires { bodies.end(); })
    {
        bodies.end();
    }
    result.seconds = seconds();
    return result;
}

} // namespace frostfill

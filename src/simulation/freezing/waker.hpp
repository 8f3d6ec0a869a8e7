// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/freezing/support_at_rest.hpp"

#include <array>
#include <vector>

namespace frostfill
{

/// Follows an object that moves: once it is filled and at rest, gravity turns, and the spheres at
/// rest that it pulls out of the cone of their contacts wake and run again, with all that rested on
/// them; everything else stays asleep.
class Waker
{
public:
    /// Where the object is in its motion, in this order. An object that never moves stays in the
    /// first.
    enum class Phase
    {
        filling, ///< it stands still, and spheres appear
        moving,
        stopped, ///< it stands still again, but what that let go may still run
        over
    };

    explicit Waker(World& world) : world_(world), support_(world) {}

    [[nodiscard]] Phase phase() const { return phase_; }
    /// The object moves, or what that let go still runs.
    [[nodiscard]] bool isMoving() const
    {
        return phase_ == Phase::moving || phase_ == Phase::stopped;
    }
    /// The pull changes with time.
    [[nodiscard]] bool pullChanges() const { return isMoving() && !timeIsUp(); }

    /// To be called when nothing runs while the object is being filled. Returns whether it begins
    /// to move; it does so once, if at all.
    bool begin();
    /// To be called when nothing runs while it moves. Returns false when it has come to rest with
    /// all in it, or when unsupported spheres have come to rest too often: the judge counts those.
    bool wakeAgain();
    /// To be called at the end of each window. Returns whether the object has just stopped.
    bool stop();
    /// To be called at the end of each window: wakes spheres that are unsupported now, when the
    /// pull's direction has changed since the last look. Returns whether any has woken.
    bool wakeWhenDue();

private:
    [[nodiscard]] bool timeIsUp() const
    {
        return world_.clock.time - world_.motionStart >= world_.motion.duration();
    }
    bool wake();
    [[nodiscard]] std::array<Eigen::Vector3d, 8> directionsAtCorners() const;

    World& world_;
    SupportAtRest support_;
    Phase phase_ = Phase::filling;
    int looks_ = 0; ///< since the object stopped, after which something ran again
    std::array<Eigen::Vector3d, 8> lookedAt_; ///< the pull's direction at the box's corners when
                                              ///< all at rest were last looked at
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <simulation/flight.hpp>
#include <simulation/parallel.hpp>
#include <simulation/runner_grid.hpp>

#include <span>
#include <vector>

namespace frostfill
{

/// Collisions of runners with each other, one after another from below (Gauss-Seidel).
class Encounters
{
public:
    struct Settings
    {
        double restitution = 0.2;
        double bounceSpeed = 0.5; ///< [sqrt(g r)]
        int sweeps = 4;
        /// Piles come to rest fast, as if what lies below could not give way; otherwise slowly, and
        /// more densely.
        bool stiff = true;
        double tolerance = 1e-3; ///< penetration depth at which the sweeps end early [r]
    };

    /// `grid` is rebuilt at each step.
    Encounters(RunnerGrid& grid, const Flight& flight, Threads& threads, const Settings& settings)
        : grid_(grid), flight_(flight), threads_(threads), settings_(settings)
    {
    }

    /// Separates the runners and makes their velocities agree with it.
    void resolve(std::span<Runner> runners, double dt);

    /// Takes runners that overlap apart, without giving them any speed.
    void separate(std::span<Runner> runners);
    /// The same among some of them, given by index, as if the others were not there.
    void separate(std::span<Runner> runners, std::span<const std::uint32_t> some);

private:
    struct Contact
    {
        std::uint32_t upper, lower; ///< runners, by index
        Eigen::Vector3d normal;     ///< from the lower to the upper
        double allowed;             ///< approach that only closes the gap [sqrt(g r)]
    };

    void findMeetings(std::span<Runner> runners);
    void findMeetingsOf(std::span<const Runner> runners, Runner& runner) const;
    void orderFromBelow(std::span<Runner> runners);
    double sweep(std::span<Runner> runners, double giveWay);
    [[nodiscard]] Eigen::Vector3d pushOff(std::span<const Runner> runners, const Runner& runner,
                                          double giveWay, double& deepest) const;
    void exchangeVelocities(std::span<Runner> runners, double dt);
    void findContacts(std::span<const Runner> runners, double dt);

    void collide(Runner& a, Runner& b, const Contact& contact) const;
    void stopOnLower(std::span<Runner> runners);
    void payForLifts(std::span<Runner> runners) const;

    RunnerGrid& grid_;
    const Flight& flight_;
    Threads& threads_;
    Settings settings_;
    Eigen::Vector3d down_ = {0, -1, 0}; ///< the pull's direction in this step
    std::vector<Contact> contacts_;    ///< of runners that overlap after their flight, lowest first
    std::vector<std::uint32_t> crowd_; ///< runners that meet others, by index, lowest first
};

} // namespace frostfill

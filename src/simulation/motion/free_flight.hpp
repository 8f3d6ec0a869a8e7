// SPDX-License-Identifier: MIT
// Room: how one sphere moves past spheres at rest and walls: free flight and drop-and-roll.
// Running spheres do not see each other here.
#pragma once

#include "simulation/contact/contact.hpp"
#include "simulation/contact/neighbour_list.hpp"
#include "simulation/motion/rolling.hpp"
#include "simulation/world/world.hpp"

#include <vector>

namespace frostfill
{

/// How a runner moves among what is at rest. It never overlaps anything at rest, however fast it is
/// or long the step: every straight part of its path ends at the first contact.
class FreeFlight
{
public:
    struct Settings
    {
        Restitution restitution;
        /// Of the speed while in contact [1 / sqrt(r/g)], where no rolling friction is given.
        double damping = 0.3;
        RollingLaw rolling = {};
    };

    FreeFlight(World& world, const Settings& settings);

    /// Acceleration of a free sphere.
    [[nodiscard]] Eigen::Vector3d pullAt(const Eigen::Vector3d& p, const Eigen::Vector3d& v) const
    {
        return world_.pull.at(p, v);
    }

    /// Unit vector along what pulls at p.
    [[nodiscard]] Eigen::Vector3d downAt(const Eigen::Vector3d& p) const
    {
        return world_.pull.direction(p);
    }

    /// Unit vector along what pulls in the middle of the object; zero when nothing does.
    [[nodiscard]] Eigen::Vector3d down() const { return downAt(Eigen::Vector3d::Zero()); }

    // Of one runner, given by its row. Several threads may treat different ones at once.

    /// Moves by one step of exact ballistic flight, with sliding and bounces.
    void advance(std::uint32_t row, double dt);

    /// Finds the normals of what is at rest and touches the runner: gaps of at most `gap` [r].
    void findContacts(std::uint32_t row, double gap);

    /// Whether what touches something at rest rolls.
    [[nodiscard]] bool rolls() const { return settings_.rolling.any(); }
    /// Whether rolling friction holds the runner where it is.
    [[nodiscard]] bool isHeld(std::uint32_t row);

    /// Moves by a displacement as far as what is at rest lets it, sliding along where it is
    /// stopped.
    void shift(std::uint32_t row, const Eigen::Vector3d& displacement);

    /// What is at rest near it.
    [[nodiscard]] NeighbourList& around(std::uint32_t row) { return around_[row]; }
    /// Of the contacts that any of the above found last.
    [[nodiscard]] std::vector<Eigen::Vector3d>& normals(std::uint32_t row) { return normals_[row]; }

    /// All forget what is at rest near them: some of it is not there any more, or is again.
    void forgetNeighbours();

private:
    [[nodiscard]] Rolling roll(std::uint32_t row, const Eigen::Vector3d& gravity);
    [[nodiscard]] double leverOf(std::uint32_t row);
    void collide(Eigen::Vector3d& velocity, std::span<const Eigen::Vector3d> normals) const;

    const World& world_;
    RunningSpheres& running_;
    Settings settings_;
    RunningColumn<NeighbourList> around_;
    RunningColumn<std::vector<Eigen::Vector3d>> normals_;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
// Room: how one sphere moves past spheres at rest and walls: free flight and drop-and-roll.
// Running spheres do not see each other here.
#pragma once

#include "simulation/contact/runner.hpp"
#include "simulation/world/world.hpp"

namespace frostfill
{

/// How a runner moves among what is at rest. It never overlaps anything at rest, however fast it is
/// or long the step: every straight part of its path ends at the first contact.
class FreeFlight
{
public:
    struct Settings
    {
        double restitution = 0.2;
        double bounceSpeed = 0.5; ///< approaches slower than this do not bounce [sqrt(g r)]
        double damping = 0.3;     ///< of the speed while in contact [1 / sqrt(r/g)]
    };

    FreeFlight(const World& world, const Settings& settings) : world_(world), settings_(settings) {}

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

    /// Moves by one step of exact ballistic flight, with sliding and bounces.
    void advance(Runner& runner, double dt) const;

    /// Finds the normals of what is at rest and touches the runner: gaps of at most `gap` [r].
    void findContacts(Runner& runner, double gap) const;

    /// Moves by a displacement as far as what is at rest lets it, sliding along where it is
    /// stopped.
    void shift(Runner& runner, const Eigen::Vector3d& displacement) const;

private:
    void collide(Runner& runner) const;

    const World& world_;
    Settings settings_;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/velocities.hpp"

#include <frostfill/snapshot.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace frostfill
{

/// All spheres as a structure of arrays, in order of appearance: the index is the id. Coordinates
/// of the run (see FrameOfRun).
struct Spheres
{
    std::vector<double> x, y, z;
    std::vector<double> radius;
    std::vector<std::uint32_t> group;
    std::vector<SphereState> state;
    Velocities velocities;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] Eigen::Vector3d position(std::size_t i) const { return {x[i], y[i], z[i]}; }
    [[nodiscard]] Eigen::Vector3d velocity(std::size_t i) const { return velocities[i]; }
    void setPosition(std::size_t i, const Eigen::Vector3d& p)
    {
        x[i] = p.x();
        y[i] = p.y();
        z[i] = p.z();
    }
    /// Sphere i runs.
    void setVelocity(std::size_t i, const Eigen::Vector3d& v) { velocities.set(i, v); }
    /// Changes the state. What stops running loses its velocity.
    void setState(std::size_t i, SphereState newState);
    /// Gives sphere `to`, which runs, all that sphere `from` has but its group.
    void moveTo(std::size_t from, std::size_t to);
    void removeLast();
    void reserve(std::size_t count);
    std::uint32_t add(const Eigen::Vector3d& p, double r, std::uint32_t groupOfSphere);
};

} // namespace frostfill

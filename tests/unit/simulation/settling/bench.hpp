// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.hpp"
#include "simulation/settling/granular_motion.hpp"
#include "support/small_world.hpp"
#include "unit/simulation/quality/packing.hpp"

#include <cmath>
#include <memory>
#include <numbers>

/// Spheres of radius 1 that run in a room twenty across, the floor at y = -10, for closed forms.
namespace frostfill
{

inline constexpr double kDegree = std::numbers::pi / 180;

class Bench
{
public:
    static constexpr double kStiff = 1e5;

    /// Gravity leans over by `slope` [rad] towards x, so that the floor is a plane that leads down.
    explicit Bench(double slope = 0, const TriangleMesh& mesh = room(), int threads = 1)
        : world_(smallWorld(mesh)), threads_(threads), slope_(slope)
    {
        world_->pull.uniform = {std::sin(slope), -std::cos(slope), 0};
    }

    /// On the floor, as deep in it as its weight presses it.
    std::uint32_t addOnFloor(double x, double z = 0)
    {
        return world_->spheres.add({x, -9 - std::cos(slope_) / kStiff, z}, 1, 0);
    }
    std::uint32_t add(const Eigen::Vector3d& place, double radius = 1)
    {
        return world_->spheres.add(place, radius, 0);
    }

    GranularMotion& start(double friction, double rollingFriction = 0, double restitution = 0.5)
    {
        motion_ = std::make_unique<GranularMotion>(
            *world_,
            ContactLaw{.stiffness = kStiff,
                       .dampingRatio = dampingRatioFor(restitution),
                       .friction = friction,
                       .wallFriction = friction,
                       .rollingFriction = rollingFriction},
            threads_);
        return *motion_;
    }
    [[nodiscard]] GranularMotion& motion() { return *motion_; }
    void advance(double time) { motion_->advance(time, {}); }

    [[nodiscard]] World& world() { return *world_; }
    [[nodiscard]] Eigen::Vector3d& place(std::uint32_t row) { return running().position[row]; }
    [[nodiscard]] Eigen::Vector3d& velocity(std::uint32_t row) { return running().velocity[row]; }
    [[nodiscard]] const Eigen::Vector3d& spin(std::uint32_t row) { return motion_->spin(row); }

private:
    [[nodiscard]] RunningSpheres& running() { return world_->spheres.running(); }

    std::unique_ptr<World> world_;
    Threads threads_;
    double slope_;
    std::unique_ptr<GranularMotion> motion_;
};

/// Spheres on a lattice with gaps, each a little away from its site, and of several sizes.
inline void addCrowd(Bench& bench, int across)
{
    std::uint64_t n = 0;
    const auto random = [&] { return uniformRandom(7, 0, n++) - 0.5; };
    for (int k = 0; k < across * across * across; ++k)
    {
        const Eigen::Vector3d site =
            Eigen::Vector3i(k % across, k / across % across, k / across / across).cast<double>();
        const Eigen::Vector3d place = Eigen::Vector3d(-8, -8.5, -8) + 2.3 * site;
        const double radius = 0.9 + 0.2 * random();
        bench.add(place + 0.2 * Eigen::Vector3d(random(), random(), random()), radius);
    }
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/solver/position_solver.hpp"
#include "simulation/solver/support_island.hpp"
#include "support/shapes.hpp"

#include <numeric>
#include <vector>

namespace frostfill
{

inline constexpr double kDt = 0.165;
inline constexpr double kFloor = -8;

inline Scene sceneOfPile()
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = 1;
    scene.threads = 1;
    return scene;
}

/// Runners in a box whose floor is at y = -8. Radii and gravity are 1.
struct Pile
{
    explicit Pile(const std::vector<Eigen::Vector3d>& places, const std::vector<double>& radii = {},
                  int threadCount = 1)
        : threads(threadCount)
    {
        for (std::size_t k = 0; k < places.size(); ++k)
        {
            world.spheres.add(places[k], radii.empty() ? 1 : radii[k], 0);
        }
    }

    void step()
    {
        for (std::uint32_t row = 0; row < running.size(); ++row)
        {
            flight.advance(row, kDt);
        }
        positionSolver.resolve(kDt);
    }

    [[nodiscard]] double energy() const
    {
        double sum = 0;
        for (std::uint32_t row = 0; row < running.size(); ++row)
        {
            sum += running.velocity[row].squaredNorm() / 2 + running.position[row].y();
        }
        return sum;
    }

    /// Those that carry one another, of all.
    std::vector<std::uint32_t> carried()
    {
        step(); // finds who meets whom
        std::vector<std::uint32_t> members(running.size());
        std::iota(members.begin(), members.end(), 0);
        SupportIsland(running, flight, positionSolver.pairs(), threads).keep(members);
        return members;
    }

    World world{sceneOfPile(), shapes::box({-8, -8, -8}, {8, 8, 8}, 8)};
    RunningSpheres& running = world.spheres.running();
    FreeFlight flight{world, {}};
    Threads threads;
    PositionSolver positionSolver{running, flight, threads, {}};
};

} // namespace frostfill

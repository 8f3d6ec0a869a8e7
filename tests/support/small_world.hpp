// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <memory>

/// Worlds of a few spheres for tests, with a radius of 1 mesh unit so that run coordinates are mesh
/// coordinates relative to the box's centre.
namespace frostfill
{

inline std::unique_ptr<World> smallWorld(const TriangleMesh& mesh)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.radius = 1;
    scene.spheres.count.reset();
    return std::make_unique<World>(scene, mesh);
}

/// Adds a sphere at rest.
inline std::uint32_t addResting(World& world, const Eigen::Vector3d& place)
{
    return world.spheres.addResting(place, 1, 0);
}

} // namespace frostfill

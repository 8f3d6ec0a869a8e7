// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace frostfill
{

/// What one time step took. [ms]
struct FpsStep
{
    std::uint32_t set = 0; ///< the newest
    double sphereSphereMs = 0;
    double spherePolygonMs = 0;
    double stepMs = 0; ///< all of it
};

/// The counts when a set had just appeared.
struct FpsRunSet
{
    std::size_t running = 0;
    std::size_t frozen = 0;
    std::size_t discarded = 0;
    std::size_t discardedPolygons = 0;
};

/// One whole run, step by step.
struct FpsRun
{
    std::vector<FpsStep> steps;
    std::vector<FpsRunSet> sets;
    std::size_t spheres = 0;
    double radius = 0;      ///< [mesh unit]
    std::size_t frozen = 0; ///< at the end
    std::size_t discarded = 0;
    std::size_t discardedPolygons = 0;
    std::string stateHash;
};
[[nodiscard]] FpsRun timeRun(const Scene& scene, const TriangleMesh& mesh);

} // namespace frostfill

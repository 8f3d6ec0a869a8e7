// SPDX-License-Identifier: MIT
#include "simulation/world/memory_need.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// For each sphere: position, velocity, states, grid [bytes]. Runs of a million take 171.
constexpr double kMemoryPerSphere = 150;

} // namespace

double memoryNeed(double spheres)
{
    return kMemoryPerSphere * spheres;
}

void requireMemory(const Scene& scene, const MeshReport& object, double radius, double spheres,
                   double bytes)
{
    if (memoryNeed(spheres) <= bytes)
    {
        return;
    }
    // What a full object of the smallest spheres that there is memory for would take.
    const double full = kMemoryPerSphere * object.volume;
    throw Error(ErrorCode::outOfMemory,
                fmt::format("spheres of radius {:.3g} in {} take more than the {:.3g} GB of memory "
                            "here; take a --radius of {:.2g} or more",
                            radius, scene.object.mesh, bytes / 1e9, std::cbrt(full / bytes)));
}

} // namespace frostfill

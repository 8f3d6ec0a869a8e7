// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace frostfill
{

/// The cost of a frame while an object fills: the paper's claim is that it holds while the number
/// of spheres grows.
struct GrowthPoint
{
    std::size_t spheres = 0;  ///< present
    double tests = 0;         ///< a time step
    double ms = 0;            ///< a time step
    double testsOfSphere = 0; ///< in all steps of the sets, for each sphere that appeared in them
    double msOfSphere = 0;
};

/// Mean cost of a time step, and of a sphere, in neighbouring sets; at most so many points. The
/// last set of the run is left out.
[[nodiscard]] std::vector<GrowthPoint> growthOfRun(const Scene& scene, const TriangleMesh& mesh,
                                                   std::size_t points);

/// What a time step of Algorithm 1 costs when nothing is frozen and all pairs are visited. A whole
/// fill would take hours, so single steps are timed on the states of the scene's own run, and what
/// a sphere costs stays 0.
[[nodiscard]] std::vector<GrowthPoint>
growthWithoutFreezing(const Scene& scene, const TriangleMesh& mesh, std::size_t points);

} // namespace frostfill

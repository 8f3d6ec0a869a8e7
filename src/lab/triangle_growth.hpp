// SPDX-License-Identifier: MIT
#pragma once

#include "fps/table.hpp"

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace frostfill
{

/// A torus whose tube is bumpy, as scans are, of about so many triangles. Its shape does not depend
/// on how many.
[[nodiscard]] TriangleMesh bumpyTorus(std::size_t triangles);

/// What the same object with the same spheres costs with so many triangles. Processor time of all
/// threads and child processes. [s]
struct TriangleGrowthPoint
{
    std::size_t triangles = 0;
    double load = 0;    ///< reading the file, inspecting and repairing
    double prepare = 0; ///< all that a simulation does before its first step
    double sphere = 0;  ///< from its release until it rests, with --motion skip
    double picture = 0; ///< of a run, the camera standing still
};

/// Measures from 10^3 to 4 10^6 triangles; `quick` up to 10^4. Progress hears the points done, all
/// of them, and what is being done.
[[nodiscard]] std::vector<TriangleGrowthPoint> measureTriangleGrowth(
    bool quick, const std::function<void(std::size_t, std::size_t, const std::string&)>& progress);

/// Of a cost that grows as a power of the number of triangles: the power, by least squares of the
/// logarithms. Points with fewer than `from` triangles do not count.
[[nodiscard]] double growthPower(const std::vector<TriangleGrowthPoint>& points,
                                 double TriangleGrowthPoint::*cost, std::size_t from);

/// One of the costs and by which power it grows.
struct TriangleGrowth
{
    const char* cost;
    double power;
};
/// Of the points with 10^4 triangles or more; where there is one only, of all.
[[nodiscard]] std::vector<TriangleGrowth>
triangleGrowth(const std::vector<TriangleGrowthPoint>& points);

[[nodiscard]] Table triangleGrowthCsv(const std::vector<TriangleGrowthPoint>& points);

} // namespace frostfill

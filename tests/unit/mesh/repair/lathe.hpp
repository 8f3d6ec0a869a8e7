// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace frostfill::test
{

/// A surface of revolution about y, of `about` corners, through (radius, height) from the bottom
/// up, wound outwards; open where the radius at an end is not 0. `lift` moves the rings up.
template <class Lift>
TriangleMesh lathe(const std::vector<std::array<double, 2>>& profile, int about, Lift&& lift)
{
    TriangleMesh mesh;
    const auto rings = static_cast<int>(profile.size());
    for (int ring = 0; ring < rings; ++ring)
    {
        for (int i = 0; i < about; ++i)
        {
            const double angle = 2 * std::numbers::pi * i / about;
            mesh.vertices.emplace_back(profile[ring][0] * std::cos(angle),
                                       profile[ring][1] + lift(ring, angle),
                                       -profile[ring][0] * std::sin(angle));
        }
    }
    const auto at = [&](int ring, int i)
    { return static_cast<std::uint32_t>(ring * about + i % about); };
    for (int ring = 0; ring + 1 < rings; ++ring)
    {
        for (int i = 0; i < about; ++i)
        {
            if (profile[ring][0] > 0)
            {
                mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
            }
            if (profile[ring + 1][0] > 0)
            {
                mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
            }
        }
    }
    return mesh;
}

inline TriangleMesh lathe(const std::vector<std::array<double, 2>>& profile, int about)
{
    TriangleMesh mesh = lathe(profile, about, [](int, double) { return 0.0; });
    // The vertices of a ring of radius 0 are one.
    for (auto& t : mesh.triangles)
    {
        for (auto& corner : t)
        {
            corner = profile[corner / about][0] > 0 ? corner : corner / about * about;
        }
    }
    return mesh;
}

/// Of frustums over regular polygons.
inline double volumeOf(const std::vector<std::array<double, 2>>& profile, int about)
{
    const double polygon = about / 2.0 * std::sin(2 * std::numbers::pi / about);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    {
        const double a = profile[i][0];
        const double b = profile[i + 1][0];
        sum += polygon * (a * a + a * b + b * b) * (profile[i + 1][1] - profile[i][1]) / 3;
    }
    return sum;
}

} // namespace frostfill::test

// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.hpp"
#include "bed/bed_surface.hpp"
#include "support/shapes.hpp"

#include <algorithm>
#include <map>
#include <vector>

/// Packings that are known, and surfaces welded again.
namespace frostfill::test
{

struct Spheres
{
    std::vector<Eigen::Vector3d> centres;
    std::vector<double> radii;
};

inline Bed bedOf(const TriangleMesh& mesh, const Spheres& spheres, const BedSettings& settings)
{
    return Bed({mesh}, spheres.centres, spheres.radii, Eigen::Vector3d::UnitY(), settings);
}

/// A face-centred crystal of unit spheres in a box that it touches: 12 contacts inside.
inline Spheres crystal(int times)
{
    Spheres spheres;
    const double half = std::sqrt(2.0);
    for (int x = 0; x <= 2 * times; ++x)
    {
        for (int y = 0; y <= 2 * times; ++y)
        {
            for (int z = 0; z <= 2 * times; ++z)
            {
                if ((x + y + z) % 2 == 0)
                {
                    spheres.centres.emplace_back(half * x, half * y, half * z);
                    spheres.radii.push_back(1);
                }
            }
        }
    }
    return spheres;
}
inline TriangleMesh crystalBox(int times, int parts = 1)
{
    const double far = 1 + 2 * times * std::sqrt(2.0);
    return shapes::box({-1, -1, -1}, {far, far, far}, parts);
}

/// Spheres of many sizes in a cube from -1 to 1, none of which overlap; each but the first touches
/// another one, or a wall, to rounding.
inline Spheres touchingSpheres(std::size_t count, double largest, double ratio)
{
    Spheres spheres;
    for (std::uint64_t draw = 0; spheres.radii.size() < count && draw < 200000; ++draw)
    {
        const auto random = [&](std::uint64_t k) { return uniformRandom(5, draw, k); };
        const Eigen::Vector3d p(2 * random(0) - 1, 2 * random(1) - 1, 2 * random(2) - 1);
        const double most = largest * std::pow(ratio, -random(3));
        double room = 1 - p.lpNorm<Eigen::Infinity>();
        for (std::size_t k = 0; k < spheres.radii.size(); ++k)
        {
            room = std::min(room, (spheres.centres[k] - p).norm() - spheres.radii[k]);
        }
        if (spheres.radii.empty() || (room < most && room > largest / ratio))
        {
            spheres.centres.push_back(p);
            spheres.radii.push_back(std::min(room, most));
        }
    }
    return spheres;
}

/// Spheres of like size in any object, each of which touches a wall or another one, to rounding.
inline Spheres touchingSpheresIn(const TriangleMesh& mesh, std::size_t count, double largest)
{
    const Surface surface(mesh);
    Spheres spheres;
    for (std::uint64_t draw = 0; spheres.radii.size() < count && draw < 200000; ++draw)
    {
        const Eigen::Vector3d random(uniformRandom(7, draw, 0), uniformRandom(7, draw, 1),
                                     uniformRandom(7, draw, 2));
        const Eigen::Vector3d p = surface.box().min() + random.cwiseProduct(surface.box().sizes());
        double room = nearestDistance(surface, p, 1e300).value;
        for (std::size_t k = 0; k < spheres.radii.size(); ++k)
        {
            room = std::min(room, (spheres.centres[k] - p).norm() - spheres.radii[k]);
        }
        if (room < largest && room > largest / 2)
        {
            spheres.centres.push_back(p);
            spheres.radii.push_back(room);
        }
    }
    return spheres;
}

/// Vertices with equal coordinates become one.
inline TriangleMesh welded(const BedSurface& surface)
{
    TriangleMesh mesh;
    std::map<std::array<float, 3>, std::uint32_t> known;
    for (std::size_t patch = 0; patch < surface.bed().patches().size(); ++patch)
    {
        surface.forEachPart(patch,
                            [&](std::span<const StlTriangle> triangles)
                            {
                                for (const StlTriangle& triangle : triangles)
                                {
                                    std::array<std::uint32_t, 3> corners{};
                                    for (std::size_t k = 0; k < 3; ++k)
                                    {
                                        const Eigen::Vector3f& p = triangle[k];
                                        const auto [entry, isNew] = known.try_emplace(
                                            {p.x(), p.y(), p.z()},
                                            static_cast<std::uint32_t>(mesh.vertices.size()));
                                        if (isNew)
                                        {
                                            mesh.vertices.push_back(p.cast<double>());
                                        }
                                        corners[k] = entry->second;
                                    }
                                    mesh.triangles.push_back(corners);
                                }
                            });
    }
    return mesh;
}

/// Sides of triangles that are not met by exactly one side in the other direction.
inline std::size_t openEdges(const TriangleMesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& triangle : mesh.triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            ++sides[{triangle[k], triangle[(k + 1) % 3]}];
        }
    }
    std::size_t open = 0;
    for (const auto& [side, times] : sides)
    {
        const auto other = sides.find({side.second, side.first});
        open += times != 1 || other == sides.end() || side.first == side.second ? 1 : 0;
    }
    return open;
}

} // namespace frostfill::test

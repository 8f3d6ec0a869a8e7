// SPDX-License-Identifier: MIT
#include "bed/geodesic_sphere.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace frostfill
{
namespace
{

/// The icosahedron, each face counter-clockwise.
const std::array<std::array<std::uint32_t, 3>, 20> kIcosahedronFaces = {
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

std::array<Eigen::Vector3d, 12> icosahedronCorners()
{
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::array<Eigen::Vector3d, 12> points = {{{-1, golden, 0},
                                               {1, golden, 0},
                                               {-1, -golden, 0},
                                               {1, -golden, 0},
                                               {0, -1, golden},
                                               {0, 1, golden},
                                               {0, -1, -golden},
                                               {0, 1, -golden},
                                               {golden, 0, -1},
                                               {golden, 0, 1},
                                               {-golden, 0, -1},
                                               {-golden, 0, 1}}};
    for (Eigen::Vector3d& point : points)
    {
        point.normalize();
    }
    return points;
}

} // namespace

TriangleMesh geodesicSphere(std::size_t parts)
{
    const std::array<Eigen::Vector3d, 12> ends = icosahedronCorners();
    TriangleMesh mesh;
    // A point is known by how much of which corners it has, so that faces share those of edges.
    std::map<std::array<std::size_t, 6>, std::uint32_t> known;
    for (const std::array<std::uint32_t, 3>& face : kIcosahedronFaces)
    {
        const auto point = [&](std::size_t b, std::size_t c)
        {
            std::array<std::pair<std::size_t, std::size_t>, 3> shares = {
                {{face[0], parts - b - c}, {face[1], b}, {face[2], c}}};
            std::sort(shares.begin(), shares.end());
            std::array<std::size_t, 6> key{};
            Eigen::Vector3d place = Eigen::Vector3d::Zero();
            std::size_t used = 0;
            for (const auto& [corner, share] : shares)
            {
                if (share > 0)
                {
                    key[used++] = corner + 1;
                    key[used++] = share;
                    place += static_cast<double>(share) * ends[corner];
                }
            }
            const auto [entry, isNew] =
                known.try_emplace(key, static_cast<std::uint32_t>(mesh.vertices.size()));
            if (isNew)
            {
                mesh.vertices.push_back(place.normalized());
            }
            return entry->second;
        };
        for (std::size_t b = 0; b < parts; ++b)
        {
            for (std::size_t c = 0; b + c < parts; ++c)
            {
                mesh.triangles.push_back({point(b, c), point(b + 1, c), point(b, c + 1)});
                if (b + c + 1 < parts)
                {
                    mesh.triangles.push_back(
                        {point(b + 1, c), point(b + 1, c + 1), point(b, c + 1)});
                }
            }
        }
    }
    return mesh;
}

} // namespace frostfill

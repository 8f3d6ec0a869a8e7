// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <vector>

/// Contacts by looking at every pair, without grids, bounds or edges in order.
namespace frostfill::test
{

struct CountedContacts
{
    std::uint32_t spheres = 0;
    std::uint32_t walls = 0;
};

/// Distance of a point to the segment ab, by trisection: it is convex along it.
inline double distanceToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b)
{
    double low = 0;
    double high = 1;
    const auto at = [&](double share) { return (a + share * (b - a) - p).norm(); };
    for (int k = 0; k < 100; ++k)
    {
        const double left = low + (high - low) / 3;
        const double right = high - (high - low) / 3;
        (at(left) < at(right) ? high : low) = at(left) < at(right) ? right : left;
    }
    return at(0.5 * (low + high));
}

/// Whether two triangles have an edge in common that is within the reach.
inline bool hangTogether(const TriangleMesh& mesh, std::size_t a, std::size_t b,
                         const Eigen::Vector3d& p, double reach)
{
    std::vector<Eigen::Vector3d> shared;
    for (const std::uint32_t corner : mesh.triangles[a])
    {
        for (const std::uint32_t other : mesh.triangles[b])
        {
            if (corner == other)
            {
                shared.push_back(mesh.vertices[corner]);
            }
        }
    }
    return shared.size() == 2 && distanceToSegment(p, shared[0], shared[1]) <= reach;
}

inline CountedContacts countContacts(const World& world, std::uint32_t id)
{
    CountedContacts counted;
    const Spheres& spheres = world.spheres;
    if (spheres.isRunning(id))
    {
        return counted;
    }
    const Eigen::Vector3d p = spheres.position(id);
    const double reach = 1.01 * spheres.radius(id);
    for (std::uint32_t other = 0; other < spheres.size(); ++other)
    {
        const double distance = (p - spheres.position(other)).norm();
        const bool touches = distance > 0 && distance - spheres.radius(other) < reach;
        counted.spheres += touches && other != id && !spheres.isRunning(other) ? 1 : 0;
    }
    const TriangleMesh& mesh = world.surface.mesh();
    std::vector<std::size_t> near;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const auto& corner = world.surface[t].corner;
        const auto closest = closestPointOnTriangle(p, corner[0], corner[1], corner[2]).point;
        if ((p - closest).norm() <= reach)
        {
            near.push_back(t);
        }
    }
    while (!near.empty()) // floods one piece after the other
    {
        ++counted.walls;
        std::vector<std::size_t> piece = {near.back()};
        near.pop_back();
        while (!piece.empty())
        {
            const std::size_t t = piece.back();
            piece.pop_back();
            std::erase_if(near,
                          [&](std::size_t other)
                          {
                              const bool belongs = hangTogether(mesh, t, other, p, reach);
                              if (belongs)
                              {
                                  piece.push_back(other);
                              }
                              return belongs;
                          });
        }
    }
    return counted;
}

} // namespace frostfill::test

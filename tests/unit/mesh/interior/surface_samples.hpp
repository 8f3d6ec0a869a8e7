// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.hpp"
#include "mesh/interior/walls.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace frostfill::test
{

inline Crossings crossingsOf(const TriangleMesh& mesh, int threadCount = 1)
{
    MeshIndex index(mesh);
    index.threads = std::make_unique<Threads>(threadCount);
    return findCrossings(mesh, index);
}

/// Each triangle in four, at the middles of its edges.
inline TriangleMesh refined(const TriangleMesh& mesh, int times)
{
    TriangleMesh result = mesh;
    for (int pass = 0; pass < times; ++pass)
    {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b)
        {
            const auto [entry, isNew] =
                middles.try_emplace(std::minmax(a, b), result.vertices.size());
            if (isNew)
            {
                const Eigen::Vector3d sum = result.vertices[a] + result.vertices[b];
                result.vertices.emplace_back(sum / 2);
            }
            return entry->second;
        };
        const auto coarse = std::exchange(result.triangles, {});
        for (const auto& [a, b, c] : coarse)
        {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const std::array<std::uint32_t, 3>& t :
                 {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
            {
                result.triangles.push_back(t);
            }
        }
    }
    return result;
}

/// A tube around a trefoil knot, of any thickness. From 0.9 on it overlaps itself.
inline TriangleMesh knotTube(std::uint32_t rings, std::uint32_t sides, double thickness)
{
    constexpr double kTurn = 6.283185307179586;
    const auto centre = [](double t) -> Eigen::Vector3d
    {
        const double away = 2 + std::cos(3 * t);
        return {away * std::cos(2 * t), away * std::sin(2 * t), std::sin(3 * t)};
    };
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < rings; ++i)
    {
        const double t = kTurn * i / rings;
        const Eigen::Vector3d along = (centre(t + 1e-3) - centre(t - 1e-3)).normalized();
        const Eigen::Vector3d u = along.cross(Eigen::Vector3d::UnitZ()).normalized();
        const Eigen::Vector3d v = along.cross(u);
        for (std::uint32_t j = 0; j < sides; ++j)
        {
            const double angle = kTurn * j / sides;
            mesh.vertices.emplace_back(centre(t) +
                                       thickness * (std::cos(angle) * u + std::sin(angle) * v));
        }
    }
    for (std::uint32_t i = 0; i < rings; ++i)
    {
        for (std::uint32_t j = 0; j < sides; ++j)
        {
            const std::uint32_t here = i * sides, there = (i + 1) % rings * sides;
            const std::uint32_t next = (j + 1) % sides;
            mesh.triangles.push_back({here + j, here + next, there + j});
            mesh.triangles.push_back({here + next, there + next, there + j});
        }
    }
    return mesh;
}

/// Two cones base to base, each a fan of needles.
inline TriangleMesh spindle(std::uint32_t needles)
{
    TriangleMesh mesh{{{0.1, 0.2, 1}, {0.3, 0.1, -1}}, {}};
    for (std::uint32_t i = 0; i < needles; ++i)
    {
        const double angle = 6.283185307179586 * i / needles;
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.3 * std::cos(angle));
        const std::uint32_t next = 2 + (i + 1) % needles;
        mesh.triangles.push_back({0, 2 + i, next});
        mesh.triangles.push_back({1, next, 2 + i});
    }
    return mesh;
}

/// A cylinder with needles for its shell and for its lids.
inline TriangleMesh drum(std::uint32_t sides)
{
    TriangleMesh mesh{{{0.1, 0.2, 0}, {0.1, 0.2, 1}}, {}};
    for (std::uint32_t i = 0; i < sides; ++i)
    {
        const double angle = 6.283185307179586 * i / sides;
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 1);
        const std::uint32_t here = 2 + 2 * i, next = 2 + 2 * ((i + 1) % sides);
        mesh.triangles.push_back({0, next, here});
        mesh.triangles.push_back({1, here + 1, next + 1});
        mesh.triangles.push_back({here, next, next + 1});
        mesh.triangles.push_back({here, next + 1, here + 1});
    }
    return mesh;
}

/// Tetrahedra wound outwards, at random places of the unit cube.
inline TriangleMesh tetrahedra(int count, double size, std::uint64_t seed)
{
    std::uint64_t draw = 0;
    const auto random = [&] { return uniformRandom(seed, 0, draw++); };
    const auto point = [&]() -> Eigen::Vector3d
    {
        const double x = random();
        const double y = random();
        return {x, y, random()};
    };
    TriangleMesh mesh;
    for (int i = 0; i < count; ++i)
    {
        const Eigen::Vector3d centre = point();
        TriangleMesh one{{}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
        for (int corner = 0; corner < 4; ++corner)
        {
            one.vertices.emplace_back(centre + size * (2 * point() - Eigen::Vector3d::Ones()));
        }
        if (signedVolume(one) < 0)
        {
            flipAll(one);
        }
        append(mesh, one);
    }
    return mesh;
}

/// A strip with a thickness, bent along a loop that crosses itself at the origin.
inline TriangleMesh loopStrip(int steps, double thickness)
{
    TriangleMesh mesh;
    for (int i = 0; i <= steps; ++i)
    {
        const double s = -1.4 + 2.8 * i / steps;
        const Eigen::Vector3d middle(s * s - 1, s * s * s - s, 0);
        const Eigen::Vector3d normal = Eigen::Vector3d(1 - 3 * s * s, 2 * s, 0).normalized();
        for (const auto& [side, z] : {std::pair(-1, 0), {1, 0}, {1, 1}, {-1, 1}})
        {
            mesh.vertices.emplace_back(middle + side * thickness / 2 * normal +
                                       z * Eigen::Vector3d::UnitZ());
        }
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
    {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(steps); ++i)
    {
        for (std::uint32_t k = 0; k < 4; ++k)
        {
            const std::uint32_t next = (k + 1) % 4;
            quad(4 * i + k, 4 * i + next, 4 * i + 4 + next, 4 * i + 4 + k);
        }
    }
    const auto last = static_cast<std::uint32_t>(4 * steps);
    quad(3, 2, 1, 0);
    quad(last, last + 1, last + 2, last + 3);
    if (signedVolume(mesh) < 0)
    {
        flipAll(mesh);
    }
    return mesh;
}

} // namespace frostfill::test

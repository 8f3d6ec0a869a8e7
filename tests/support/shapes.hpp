// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

/// Meshes with known properties, made on the spot. All are closed and wound outwards.
namespace frostfill::shapes
{

/// An axis-aligned box from `low` to `high`, each face cut into n x n quads of two triangles.
inline TriangleMesh box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int n = 1)
{
    TriangleMesh mesh;
    const auto vertex = [&](const std::array<int, 3>& c) -> std::uint32_t
    {
        Eigen::Vector3d p;
        for (int axis = 0; axis < 3; ++axis)
        {
            p[axis] = low[axis] + (high[axis] - low[axis]) * c[axis] / n;
        }
        for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i)
        {
            if (mesh.vertices[i] == p)
            {
                return i;
            }
        }
        mesh.vertices.push_back(p);
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    };
    for (int axis = 0; axis < 3; ++axis)
    {
        for (int side = 0; side < 2; ++side)
        {
            for (int u = 0; u < n; ++u)
            {
                for (int v = 0; v < n; ++v)
                {
                    const auto corner = [&](int du, int dv)
                    {
                        std::array<int, 3> c{};
                        c[axis] = side * n;
                        c[(axis + 1) % 3] = u + du;
                        c[(axis + 2) % 3] = v + dv;
                        return vertex(c);
                    };
                    std::array<std::uint32_t, 4> q = {corner(0, 0), corner(1, 0), corner(1, 1),
                                                      corner(0, 1)};
                    if (side == 0)
                    {
                        std::swap(q[1], q[3]);
                    }
                    mesh.triangles.push_back({q[0], q[1], q[2]});
                    mesh.triangles.push_back({q[0], q[2], q[3]});
                }
            }
        }
    }
    return mesh;
}

/// A torus standing on its rim: ring of radius R in the x-y plane, tube of radius r.
inline TriangleMesh torus(double ring = 1, double tube = 0.4, int segments = 48, int sides = 12)
{
    TriangleMesh mesh;
    for (int i = 0; i < segments; ++i)
    {
        const double a = 2 * std::numbers::pi * i / segments;
        for (int j = 0; j < sides; ++j)
        {
            const double b = 2 * std::numbers::pi * j / sides;
            const double radius = ring + tube * std::cos(b);
            mesh.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a),
                                       tube * std::sin(b));
        }
    }
    const auto at = [&](int i, int j)
    { return static_cast<std::uint32_t>((i % segments) * sides + j % sides); };
    for (int i = 0; i < segments; ++i)
    {
        for (int j = 0; j < sides; ++j)
        {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

} // namespace frostfill::shapes

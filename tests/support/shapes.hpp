// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <vector>

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

/// The surface of a union of cells of a grid with planes at the given coordinates, ascending. Cell
/// (i, j, k) lies between planes i and i + 1, ...; `filled` says which there are. No two of them
/// may touch in an edge or a corner alone.
template <class Filled>
TriangleMesh gridCells(const std::array<std::vector<double>, 3>& planes, Filled&& filled)
{
    using Index = std::array<int, 3>;
    TriangleMesh mesh;
    std::map<Index, std::uint32_t> numbers;
    const auto vertex = [&](const Index& at)
    {
        const auto [entry, isNew] =
            numbers.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (isNew)
        {
            mesh.vertices.emplace_back(planes[0][at[0]], planes[1][at[1]], planes[2][at[2]]);
        }
        return entry->second;
    };
    const auto exists = [&](const Index& cell)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            if (cell[axis] < 0 || cell[axis] + 1 >= static_cast<int>(planes[axis].size()))
            {
                return false;
            }
        }
        return filled(cell);
    };
    const auto addFace = [&](Index cell, int axis, int side)
    {
        cell[axis] += side;
        std::array<std::uint32_t, 4> quad{};
        for (int k = 0; k < 4; ++k)
        {
            Index corner = cell;
            corner[(axis + 1) % 3] += (k == 1 || k == 2) ? 1 : 0;
            corner[(axis + 2) % 3] += k / 2;
            quad[k] = vertex(corner);
        }
        if (side == 0)
        {
            std::swap(quad[1], quad[3]);
        }
        mesh.triangles.push_back({quad[0], quad[1], quad[2]});
        mesh.triangles.push_back({quad[0], quad[2], quad[3]});
    };
    Index cell{};
    for (cell[0] = 0; cell[0] + 1 < static_cast<int>(planes[0].size()); ++cell[0])
    {
        for (cell[1] = 0; cell[1] + 1 < static_cast<int>(planes[1].size()); ++cell[1])
        {
            for (cell[2] = 0; cell[2] + 1 < static_cast<int>(planes[2].size()); ++cell[2])
            {
                for (int face = 0; face < 6 && exists(cell); ++face)
                {
                    Index next = cell;
                    next[face / 2] += face % 2 == 0 ? -1 : 1;
                    if (!exists(next))
                    {
                        addFace(cell, face / 2, face % 2);
                    }
                }
            }
        }
    }
    return mesh;
}

/// A cube of edge 2 about the origin with a wall across its middle, 0.1 thick, that ends 0.6 below
/// the lid: two chambers that are open to each other at the top.
inline TriangleMesh partitionedBox()
{
    const std::vector<double> even = {-1, -0.8, -0.6, -0.4, -0.2, 0, 0.2, 0.4, 0.6, 0.8, 1};
    const std::vector<double> across = {-1, -0.75, -0.5, -0.25, -0.05, 0.05, 0.25, 0.5, 0.75, 1};
    return gridCells({across, even, even},
                     [](const std::array<int, 3>& cell) { return cell[0] != 4 || cell[1] >= 7; });
}

/// A tube of radius 0.25 along a swan's neck in the x-y plane: down, round, up, over and down
/// again. What falls in at the top of the first leg gets no farther than the rising one, and the
/// bend above hangs over everything below it.
inline TriangleMesh bentTube(int sides = 16)
{
    constexpr double kTube = 0.25;
    constexpr double kBend = 0.45;
    struct Point
    {
        double x, y;
        double nx, ny; ///< across the path, in its plane
    };
    std::vector<Point> path;
    const auto straight = [&](double x, double from, double to, double nx)
    {
        for (int k = 0; k < 8; ++k)
        {
            path.push_back({x, from + (to - from) * k / 8, nx, 0});
        }
    };
    const auto bend = [&](double x, double y, bool below)
    {
        for (int k = 0; k < 12; ++k)
        {
            const double angle = std::numbers::pi * k / 12;
            const double c = -std::cos(angle);
            const double s = below ? -std::sin(angle) : std::sin(angle);
            path.push_back({x + kBend * c, y + kBend * s, below ? -c : c, below ? -s : s});
        }
    };
    straight(0, 2, 0.75, 1);
    bend(kBend, 0.75, true);
    straight(2 * kBend, 0.75, 1.3, -1);
    bend(3 * kBend, 1.3, false);
    straight(4 * kBend, 1.3, 0.3, 1);
    path.push_back({4 * kBend, 0.3, 1, 0});

    TriangleMesh mesh;
    for (const Point& p : path)
    {
        for (int k = 0; k < sides; ++k)
        {
            const double angle = 2 * std::numbers::pi * k / sides;
            const double across = kTube * std::cos(angle);
            mesh.vertices.emplace_back(p.x + across * p.nx, p.y + across * p.ny,
                                       kTube * std::sin(angle));
        }
    }
    const auto rings = static_cast<int>(path.size());
    const auto at = [&](int ring, int k)
    { return static_cast<std::uint32_t>(ring * sides + k % sides); };
    for (int ring = 0; ring + 1 < rings; ++ring)
    {
        for (int k = 0; k < sides; ++k)
        {
            mesh.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
            mesh.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
        }
    }
    for (const int ring : {0, rings - 1})
    {
        const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.emplace_back(path[ring].x, path[ring].y, 0);
        for (int k = 0; k < sides; ++k)
        {
            const int first = ring == 0 ? k + 1 : k;
            mesh.triangles.push_back({middle, at(ring, first), at(ring, 2 * k + 1 - first)});
        }
    }
    return mesh;
}

/// A standing cylinder about the y axis, with flat ends of triangles about their middle.
inline TriangleMesh cylinder(double radius, double height, int sides)
{
    TriangleMesh mesh;
    mesh.vertices = {{0, -height / 2, 0}, {0, height / 2, 0}};
    for (int k = 0; k < sides; ++k)
    {
        const double turn = 2 * std::numbers::pi * k / sides;
        const double x = radius * std::cos(turn);
        const double z = radius * std::sin(turn);
        mesh.vertices.emplace_back(x, -height / 2, z);
        mesh.vertices.emplace_back(x, height / 2, z);
    }
    for (int k = 0; k < sides; ++k)
    {
        const auto low = static_cast<std::uint32_t>(2 + 2 * k);
        const auto next = static_cast<std::uint32_t>(2 + 2 * ((k + 1) % sides));
        mesh.triangles.push_back({0, low, next});
        mesh.triangles.push_back({1, next + 1, low + 1});
        mesh.triangles.push_back({low, low + 1, next + 1});
        mesh.triangles.push_back({low, next + 1, next});
    }
    return mesh;
}

} // namespace frostfill::shapes

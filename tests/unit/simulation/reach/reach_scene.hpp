// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/inside_test.hpp"
#include "simulation/reach/open_cubes.hpp"
#include "support/brute_distance.hpp"
#include "support/random_points.hpp"
#include "support/shapes.hpp"

#include <array>
#include <map>
#include <set>
#include <vector>

namespace frostfill::reach
{

/// A mesh with its searches, in radii of the spheres.
struct Object
{
    explicit Object(const TriangleMesh& mesh)
        : surface(mesh), grid(surface, GridFrame::cover(surface.box(), 1, 2), 1.5),
          inside(surface, grid)
    {
    }
    Object(const Object&) = delete;
    Object& operator=(const Object&) = delete;

    Surface surface;
    TriangleGrid grid;
    InsideTest inside;
};

struct Ball
{
    Eigen::Vector3d centre;
    double radius = 1;
};

using Random = RandomPoints;

/// A cube about the origin.
inline TriangleMesh cubeOfSide(double side, int n = 2)
{
    return shapes::box(Eigen::Vector3d::Constant(-side / 2), Eigen::Vector3d::Constant(side / 2),
                       n);
}

/// The surface of a union of unit cubes, given by their lower corners. No two of them may touch in
/// an edge or a corner alone.
inline TriangleMesh cubes(const std::set<std::array<int, 3>>& cells)
{
    TriangleMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> numbers;
    const auto vertex = [&](const std::array<int, 3>& c)
    {
        const auto [entry, isNew] =
            numbers.try_emplace(c, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (isNew)
        {
            mesh.vertices.emplace_back(c[0], c[1], c[2]);
        }
        return entry->second;
    };
    for (const auto& cell : cells)
    {
        for (int face = 0; face < 6; ++face)
        {
            const int axis = face / 2;
            const int side = face % 2;
            auto next = cell;
            next[axis] += side == 0 ? -1 : 1;
            if (cells.count(next) != 0)
            {
                continue;
            }
            std::array<std::uint32_t, 4> quad{};
            for (int k = 0; k < 4; ++k)
            {
                auto c = cell;
                c[axis] += side;
                c[(axis + 1) % 3] += (k == 1 || k == 2) ? 1 : 0;
                c[(axis + 2) % 3] += k / 2;
                quad[k] = vertex(c);
            }
            if (side == 0)
            {
                std::swap(quad[1], quad[3]);
            }
            mesh.triangles.push_back({quad[0], quad[1], quad[2]});
            mesh.triangles.push_back({quad[0], quad[2], quad[3]});
        }
    }
    return mesh;
}

inline void addBlock(std::set<std::array<int, 3>>& cells, const std::array<int, 3>& low,
                     const std::array<int, 3>& high)
{
    for (int x = low[0]; x < high[0]; ++x)
    {
        for (int y = low[1]; y < high[1]; ++y)
        {
            for (int z = low[2]; z < high[2]; ++z)
            {
                cells.insert({x, y, z});
            }
        }
    }
}

inline TriangleMesh turned(TriangleMesh mesh, double angle)
{
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()))
                                     .toRotationMatrix();
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = turn * vertex;
    }
    return mesh;
}

/// Through the whole of its box, and of twelve triangles.
inline TriangleMesh slantedTube(double length, double side)
{
    return turned(
        shapes::box({-side / 2, -length / 2, -side / 2}, {side / 2, length / 2, side / 2}), 0.7);
}

inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b)
{
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& t : b.triangles)
    {
        a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return a;
}

/// Calls visit(place, isOpen) for every cube of the grid.
template <class Visit>
void forEachCubeOf(const OpenCubes& open, Visit&& visit)
{
    const auto& count = open.cubes.frame().count;
    for (int z = 0; z < count[2]; ++z)
    {
        for (int y = 0; y < count[1]; ++y)
        {
            for (int x = 0; x < count[0]; ++x)
            {
                const CubeWord cube = open.cubes.at(GridPlace{x, y, z});
                visit(GridPlace{x, y, z}, (open.inside[cube.word] & cube.bits) != 0);
            }
        }
    }
}

} // namespace frostfill::reach

// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_columns.hpp"

#include "geometry/exact_predicates.hpp"
#include "mesh/triangle_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

/// Columns for each triangle, and at most in each direction. Larger: fewer triangles a column, and
/// memory where triangles are large.
constexpr double kColumnsPerTriangle = 0.5;
constexpr double kMaxColumns = 512;

/// [1] Of the size of the mesh and its distance from the origin, which is far above rounding.
/// Larger: a wall close by is passed.
constexpr double kBeside = 1e-12;

/// orient2d for a ray that passes by p as if moved by an infinitely small (e, e^2), so that it
/// meets no corner and no edge [Edelsbrunner & Muecke 1990].
int orientMoved(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p)
{
    const int side = orient2d(a, b, p);
    if (side != 0)
    {
        return side;
    }
    if (a.y() != b.y())
    {
        return a.y() > b.y() ? 1 : -1;
    }
    return a.x() == b.x() ? 0 : (b.x() > a.x() ? 1 : -1);
}

} // namespace

WindingColumns::WindingColumns(const TriangleMesh& mesh) : mesh_(&mesh), box_(boundingBox(mesh))
{
    if (mesh.triangles.empty())
    {
        columns_ = Buckets<std::uint32_t>(1, [](auto&&) {});
        return;
    }
    int along = 0; // few walls lie one behind the other along the shortest side
    box_.sizes().minCoeff(&along);
    across_ = {(along + 1) % 3, (along + 2) % 3};
    const double columns =
        std::sqrt(kColumnsPerTriangle * static_cast<double>(mesh.triangles.size()));
    count_.fill(static_cast<int>(std::clamp(columns, 1.0, kMaxColumns)));

    // A triangle is in the columns of the box of its corners: those between their own.
    std::vector<std::array<std::uint16_t, 2>> ofVertex(mesh.vertices.size());
    std::transform(mesh.vertices.begin(), mesh.vertices.end(), ofVertex.begin(),
                   [this](const Eigen::Vector3d& vertex)
                   {
                       const Eigen::Vector2d at = flat(vertex);
                       return std::array{static_cast<std::uint16_t>(columnOf(at.x(), 0)),
                                         static_cast<std::uint16_t>(columnOf(at.y(), 1))};
                   });
    const auto enterAll = [&](auto&& enter)
    {
        for (std::uint32_t id = 0; id < mesh.triangles.size(); ++id)
        {
            const auto& [a, b, c] = mesh.triangles[id];
            const auto [firstX, lastX] =
                std::minmax({ofVertex[a][0], ofVertex[b][0], ofVertex[c][0]});
            const auto [firstY, lastY] =
                std::minmax({ofVertex[a][1], ofVertex[b][1], ofVertex[c][1]});
            for (std::size_t y = firstY; y <= lastY; ++y)
            {
                for (std::size_t x = firstX; x <= lastX; ++x)
                {
                    enter(y * static_cast<std::size_t>(count_[0]) + x, id);
                }
            }
        }
    };
    columns_ = Buckets<std::uint32_t>(
        static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]), enterAll);
}

int WindingColumns::columnOf(double coordinate, std::size_t k) const
{
    const int axis = across_[k];
    const double size = box_.sizes()[axis];
    const double column =
        size > 0 ? std::floor((coordinate - box_.min()[axis]) / size * count_[k]) : 0;
    return static_cast<int>(std::clamp(column, 0.0, count_[k] - 1.0));
}

int WindingColumns::at(const Eigen::Vector3d& p) const
{
    if (!box_.contains(p))
    {
        return 0;
    }
    int winding = 0;
    forEachPassage(p,
                   [&](std::uint32_t id, int change)
                   {
                       // Counter-clockwise seen from the ray's end, a triangle is left through
                       // where p is behind it.
                       const auto& [a, b, c] = mesh_->triangles[id];
                       const int side =
                           orient3d(mesh_->vertices[a], mesh_->vertices[b], mesh_->vertices[c], p);
                       winding += side == -change ? change : 0;
                   });
    return winding;
}

WindingColumns::Sides WindingColumns::sidesOf(const Eigen::Vector3d& p,
                                              const Eigen::Vector3d& outward) const
{
    const double step = kBeside * (box_.diagonal().norm() + p.norm());
    return {at(p + step * outward), at(p - step * outward)};
}

std::vector<WindingColumns::Stretch> WindingColumns::stretchesInside(const Eigen::Vector3d& p) const
{
    thread_local std::vector<std::pair<double, int>> walls; // keeps its memory
    walls.clear();
    forEachPassage(p,
                   [&](std::uint32_t triangle, int change)
                   {
                       const auto [a, b, c] = cornersOf(*mesh_, triangle);
                       const auto [u, v] = across_;
                       const Eigen::Vector3d normal = (b - a).cross(c - a);
                       const double rise = normal[u] * (p[u] - a[u]) + normal[v] * (p[v] - a[v]);
                       const auto [low, high] = std::minmax({a[along()], b[along()], c[along()]});
                       walls.emplace_back(
                           std::clamp(a[along()] - rise / normal[along()], low, high), change);
                   });
    std::sort(walls.begin(), walls.end());
    std::vector<Stretch> stretches;
    int winding = 0; // before the next wall
    for (std::size_t k = 0; k + 1 < walls.size(); ++k)
    {
        winding -= walls[k].second;
        if (winding > 0)
        {
            stretches.push_back({walls[k].first, walls[k + 1].first});
        }
    }
    return stretches;
}

// By how much the winding number is larger before the ray from p passes a triangle than after.
int WindingColumns::passage(const std::array<std::uint32_t, 3>& triangle,
                            const Eigen::Vector3d& p) const
{
    const Eigen::Vector3d& a = mesh_->vertices[triangle[0]];
    const Eigen::Vector3d& b = mesh_->vertices[triangle[1]];
    const Eigen::Vector3d& c = mesh_->vertices[triangle[2]];
    const Eigen::Vector2d q = flat(p);
    const Eigen::Vector2d fa = flat(a), fb = flat(b), fc = flat(c);
    if (q.x() < std::min({fa.x(), fb.x(), fc.x()}) || q.x() > std::max({fa.x(), fb.x(), fc.x()}) ||
        q.y() < std::min({fa.y(), fb.y(), fc.y()}) || q.y() > std::max({fa.y(), fb.y(), fc.y()}))
    {
        return 0;
    }
    const int side = orientMoved(fa, fb, q);
    if (side == 0 || orientMoved(fb, fc, q) != side || orientMoved(fc, fa, q) != side)
    {
        return 0;
    }
    return side;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "mesh/interior/interior_volume.hpp"

#include "mesh/interior/separate_boxes.hpp"
#include "mesh/interior/winding_columns.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frostfill
{
namespace
{

/// Rays in each direction across them, one a cell of a grid. Larger: a smaller error, and time by
/// the square.
constexpr std::size_t kRays = 1024;
/// Multiples of it fill a line evenly. Rays lie elsewhere in each cell: where a wall is along a row
/// of cells, the right share of them is inside.
constexpr double kGoldenRatio = 1.618033988749895;

/// When the parts of a mesh fill less of its box, each has rays of its own. Larger: time, for one
/// grid would do. Smaller: too few rays meet a part.
constexpr double kSparse = 0.02;

/// Of the parts of the line through p along the rays that are inside.
double lengthInside(const TriangleMesh& mesh, const WindingColumns& columns,
                    const Eigen::Vector3d& p, std::vector<std::pair<double, int>>& walls)
{
    const int along = columns.along();
    const int u = (along + 1) % 3;
    const int v = (along + 2) % 3;
    walls.clear();
    columns.forEachPassage(
        p,
        [&](std::uint32_t triangle, int change)
        {
            const auto& t = mesh.triangles[triangle];
            const Eigen::Vector3d& a = mesh.vertices[t[0]];
            const Eigen::Vector3d& b = mesh.vertices[t[1]];
            const Eigen::Vector3d& c = mesh.vertices[t[2]];
            const Eigen::Vector3d normal = (b - a).cross(c - a);
            const double rise = (normal[u] * (p[u] - a[u]) + normal[v] * (p[v] - a[v]));
            const auto [low, high] = std::minmax({a[along], b[along], c[along]});
            walls.emplace_back(std::clamp(a[along] - rise / normal[along], low, high), change);
        });
    std::sort(walls.begin(), walls.end());
    double length = 0;
    int winding = 0; // before the next wall
    for (std::size_t k = 0; k + 1 < walls.size(); ++k)
    {
        winding -= walls[k].second;
        length += winding > 0 ? walls[k + 1].first - walls[k].first : 0;
    }
    return length;
}

/// The same sum whatever the number of threads: that of one row of rays after another.
double volumeOfPart(const TriangleMesh& mesh, Threads& threads)
{
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    if (mesh.triangles.empty() || !(box.sizes().minCoeff() > 0))
    {
        return 0;
    }
    const WindingColumns columns(mesh);
    const int u = (columns.along() + 1) % 3;
    const int v = (columns.along() + 2) % 3;
    std::vector<double> rows(kRays);
    threads.forEachLarge(kRays,
                         [&](std::size_t row)
                         {
                             const auto share = [](std::size_t cell, std::size_t other)
                             {
                                 const double moved = kGoldenRatio * static_cast<double>(other);
                                 return (static_cast<double>(cell) + moved - std::floor(moved)) /
                                        kRays;
                             };
                             std::vector<std::pair<double, int>> walls;
                             Eigen::Vector3d p = box.min();
                             for (std::size_t k = 0; k < kRays; ++k)
                             {
                                 p[u] = box.min()[u] + share(k, row) * box.sizes()[u];
                                 p[v] = box.min()[v] + share(row, k) * box.sizes()[v];
                                 rows[row] += lengthInside(mesh, columns, p, walls);
                             }
                         });
    const double length = std::accumulate(rows.begin(), rows.end(), 0.0);
    return length / (kRays * kRays) * box.sizes()[u] * box.sizes()[v];
}

} // namespace

double interiorVolume(const TriangleMesh& mesh)
{
    Threads one(1);
    return interiorVolume(mesh, one);
}

double interiorVolume(const TriangleMesh& mesh, Threads& threads)
{
    const std::vector<Eigen::AlignedBox3d> boxes = separateBoxes(mesh, 0);
    double filled = 0;
    for (const Eigen::AlignedBox3d& box : boxes)
    {
        filled += box.volume();
    }
    if (filled >= kSparse * boundingBox(mesh).volume())
    {
        return volumeOfPart(mesh, threads);
    }
    double volume = 0;
    for (const TriangleMesh& part : separateParts(mesh, boxes))
    {
        volume += volumeOfPart(part, threads);
    }
    return volume;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_columns.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace frostfill
{

double signedVolume(const TriangleMesh& mesh)
{
    // Relative to the middle, so a small object far from the origin loses no digits.
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    const Eigen::Vector3d middle = box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.center();
    double sixfold = 0;
    for (const auto& t : mesh.triangles)
    {
        const Eigen::Vector3d a = mesh.vertices[t[0]] - middle;
        const Eigen::Vector3d b = mesh.vertices[t[1]] - middle;
        const Eigen::Vector3d c = mesh.vertices[t[2]] - middle;
        sixfold += a.dot(b.cross(c));
    }
    return sixfold / 6;
}

double surfaceArea(const TriangleMesh& mesh)
{
    double twice = 0;
    for (const auto& t : mesh.triangles)
    {
        const Eigen::Vector3d& a = mesh.vertices[t[0]];
        twice += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    }
    return twice / 2;
}

Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const auto& t : mesh.triangles)
    {
        for (const std::uint32_t corner : t)
        {
            box.extend(mesh.vertices[corner]);
        }
    }
    return box;
}

namespace
{

/// Rays in each direction across them, one a cell of a grid. Larger: a smaller error, and time by
/// the square.
constexpr std::size_t kRays = 1024;
/// Multiples of it fill a line evenly. Rays lie elsewhere in each cell: where a wall is along a row
/// of cells, the right share of them is inside.
constexpr double kGoldenRatio = 1.618033988749895;

} // namespace

double interiorVolume(const TriangleMesh& mesh)
{
    Threads one(1);
    return interiorVolume(mesh, one);
}

// The same sum whatever the number of threads: that of one row of rays after another.
double interiorVolume(const TriangleMesh& mesh, Threads& threads)
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
                             Eigen::Vector3d p = box.min();
                             for (std::size_t k = 0; k < kRays; ++k)
                             {
                                 p[u] = box.min()[u] + share(k, row) * box.sizes()[u];
                                 p[v] = box.min()[v] + share(row, k) * box.sizes()[v];
                                 for (const auto& [low, high] : columns.stretchesInside(p))
                                 {
                                     rows[row] += high - low;
                                 }
                             }
                         });
    const double length = std::accumulate(rows.begin(), rows.end(), 0.0);
    return length / (kRays * kRays) * box.sizes()[u] * box.sizes()[v];
}

} // namespace frostfill

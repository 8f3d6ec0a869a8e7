// SPDX-License-Identifier: MIT
#include "run/ceilings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

constexpr double kTrianglesPerCell = 4;
constexpr int kMaxCells = 1024; // along an axis

} // namespace

Ceilings::Ceilings(const TriangleMesh& mesh, const Eigen::Vector3d& up)
    : mesh_(mesh), box_(boundingBox(mesh))
{
    up.maxCoeff(&up_);
    ground_[0] = (up_ + 1) % 3;
    ground_[1] = (up_ + 2) % 3;
    const double cells = std::sqrt(static_cast<double>(mesh.triangles.size()) / kTrianglesPerCell);
    count_ = std::clamp(static_cast<int>(cells), 1, kMaxCells);

    // Count, sum up, and put in place.
    const auto forEachCell = [&](std::uint32_t t, auto&& visit)
    {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t vertex : mesh.triangles[t])
        {
            box.extend(mesh.vertices[vertex]);
        }
        for (int i = cell(box.min()[ground_[0]], 0); i <= cell(box.max()[ground_[0]], 0); ++i)
        {
            for (int j = cell(box.min()[ground_[1]], 1); j <= cell(box.max()[ground_[1]], 1); ++j)
            {
                visit(static_cast<std::size_t>(i) * static_cast<std::size_t>(count_) +
                      static_cast<std::size_t>(j));
            }
        }
    };
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    starts_.assign(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_) + 1, 0);
    for (std::uint32_t t = 0; t < triangles; ++t)
    {
        forEachCell(t, [&](std::size_t c) { ++starts_[c + 1]; });
    }
    for (std::size_t c = 1; c < starts_.size(); ++c)
    {
        starts_[c] += starts_[c - 1];
    }
    triangles_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t t = 0; t < triangles; ++t)
    {
        forEachCell(t, [&](std::size_t c) { triangles_[next[c]++] = t; });
    }
}

int Ceilings::cell(double at, int axis) const
{
    const int g = ground_[axis];
    const double share = (at - box_.min()[g]) / std::max(1e-300, box_.sizes()[g]);
    return std::clamp(static_cast<int>(share * count_), 0, count_ - 1);
}

double Ceilings::heightOver(std::uint32_t triangle, const Eigen::Vector3d& p) const
{
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const auto side = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to)
    {
        return (to[ground_[0]] - from[ground_[0]]) * (p[ground_[1]] - from[ground_[1]]) -
               (to[ground_[1]] - from[ground_[1]]) * (p[ground_[0]] - from[ground_[0]]);
    };
    const Eigen::Vector3d& u = mesh_.vertices[a];
    const Eigen::Vector3d& v = mesh_.vertices[b];
    const Eigen::Vector3d& w = mesh_.vertices[c];
    const double alongU = side(v, w);
    const double alongV = side(w, u);
    const double alongW = side(u, v);
    const double sum = alongU + alongV + alongW;
    const bool over =
        (alongU >= 0 && alongV >= 0 && alongW >= 0) || (alongU <= 0 && alongV <= 0 && alongW <= 0);
    if (!over || sum == 0)
    {
        return -std::numeric_limits<double>::infinity();
    }
    return (alongU * u[up_] + alongV * v[up_] + alongW * w[up_]) / sum;
}

double Ceilings::above(const Eigen::Vector3d& p) const
{
    const std::size_t c =
        static_cast<std::size_t>(cell(p[ground_[0]], 0)) * static_cast<std::size_t>(count_) +
        static_cast<std::size_t>(cell(p[ground_[1]], 1));
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = starts_[c]; k < starts_[c + 1]; ++k)
    {
        const double height = heightOver(triangles_[k], p) - p[up_];
        nearest = height > 0 ? std::min(nearest, height) : nearest;
    }
    return std::isfinite(nearest) ? nearest : 0;
}

} // namespace frostfill

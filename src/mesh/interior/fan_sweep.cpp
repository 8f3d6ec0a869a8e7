// SPDX-License-Identifier: MIT
#include "mesh/interior/fan_sweep.hpp"

#include <algorithm>
#include <tuple>

namespace frostfill
{
namespace
{

/// [1] Margin of a box for the rounding of unit vectors. Smaller: arcs that meet are missed.
constexpr double kRounding = 1e-14;

Eigen::AlignedBox3d boxOfArc(const TriangleMesh& mesh, std::uint32_t triangle, std::uint32_t vertex)
{
    const auto& t = mesh.triangles[triangle];
    const std::size_t corner = t[0] == vertex ? 0 : (t[1] == vertex ? 1 : 2);
    const Eigen::Vector3d& from = mesh.vertices[vertex];
    const Eigen::Vector3d u = (mesh.vertices[t[(corner + 1) % 3]] - from).normalized();
    const Eigen::Vector3d v = (mesh.vertices[t[(corner + 2) % 3]] - from).normalized();
    // How far the arc rises above its chord.
    const double rise = std::max(0.0, 1 - (u + v).norm() / 2) + kRounding;
    return {u.cwiseMin(v).array() - rise, u.cwiseMax(v).array() + rise};
}

} // namespace

int FanSweep::sortArcs(const TriangleMesh& mesh, std::uint32_t vertex,
                       std::span<const std::uint32_t> triangles)
{
    arcs_.clear();
    Eigen::AlignedBox3d whole;
    for (const std::uint32_t triangle : triangles)
    {
        arcs_.push_back({boxOfArc(mesh, triangle, vertex), triangle});
        whole.extend(arcs_.back().box.center());
    }
    int axis = 0;
    whole.sizes().maxCoeff(&axis);
    std::sort(arcs_.begin(), arcs_.end(),
              [=](const Arc& a, const Arc& b) {
                  return std::tie(a.box.min()[axis], a.triangle) <
                         std::tie(b.box.min()[axis], b.triangle);
              });
    return axis;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "mesh/interior/spread_fan.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace frostfill
{
namespace
{

constexpr std::size_t kMax = 16; // triangles; beyond, all against all costs more than a sweep

/// [1] Share of the product of the lengths by which a determinant must differ from 0. Larger: more
/// fans are tested pair by pair. Below some 10 roundings of 1e-16: a fold is taken for a fan.
constexpr double kSurely = 1e-13;

struct Wedge
{
    std::uint32_t from = 0; ///< vertex
    std::uint32_t to = 0;   ///< vertex
    Eigen::Vector3d u, v;   ///< from the common vertex to both
    Eigen::Vector3d normal; ///< u x v
    double uLength = 0, vLength = 0;
};

Wedge wedgeOf(const TriangleMesh& mesh, std::uint32_t vertex, std::uint32_t triangle)
{
    const auto& t = mesh.triangles[triangle];
    const std::size_t corner = t[0] == vertex ? 0 : (t[1] == vertex ? 1 : 2);
    Wedge wedge;
    wedge.from = t[(corner + 1) % 3];
    wedge.to = t[(corner + 2) % 3];
    wedge.u = mesh.vertices[wedge.from] - mesh.vertices[vertex];
    wedge.v = mesh.vertices[wedge.to] - mesh.vertices[vertex];
    wedge.normal = wedge.u.cross(wedge.v);
    wedge.uLength = wedge.u.norm();
    wedge.vLength = wedge.v.norm();
    return wedge;
}

/// Each wedge ends where exactly one begins, so the wedges form closed fans.
bool areClosed(std::span<const Wedge> wedges)
{
    return std::all_of(wedges.begin(), wedges.end(),
                       [&](const Wedge& wedge)
                       {
                           return std::count_if(wedges.begin(), wedges.end(),
                                                [&](const Wedge& next)
                                                { return next.from == wedge.to; }) == 1;
                       });
}

} // namespace

bool isSpreadFan(const TriangleMesh& mesh, std::uint32_t vertex,
                 std::span<const std::uint32_t> triangles)
{
    if (triangles.empty() || triangles.size() > kMax)
    {
        return false;
    }
    std::array<Wedge, kMax> all;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
        all[i] = wedgeOf(mesh, vertex, triangles[i]);
        axis += all[i].normal;
    }
    const std::span wedges(all.data(), triangles.size());
    const double axisLength = axis.norm();
    const auto turnsForward = [&](const Wedge& w)
    { return w.normal.dot(axis) > kSurely * w.uLength * w.vLength * axisLength; };
    if (!std::all_of(wedges.begin(), wedges.end(), turnsForward) || !areClosed(wedges))
    {
        return false;
    }

    // Closed and never backwards: every direction about the axis is in equally many wedges. One
    // direction in the first wedge is in no other, so that is one.
    const Eigen::Vector3d middle =
        wedges[0].u / wedges[0].uLength + wedges[0].v / wedges[0].vLength;
    const Eigen::Vector3d across = middle.cross(axis);
    const double margin = kSurely * 2 * axisLength;
    return std::all_of(wedges.begin() + 1, wedges.end(),
                       [&](const Wedge& w)
                       {
                           // det(axis, u, middle) = u . (middle x axis)
                           return w.u.dot(across) < -margin * w.uLength ||
                                  w.v.dot(across) > margin * w.vLength;
                       });
}

} // namespace frostfill

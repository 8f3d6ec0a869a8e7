// SPDX-License-Identifier: MIT
#include "bed/head_space.hpp"

#include "mesh/repair/repair_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace frostfill
{
namespace
{

/// Share of the height of a mesh by which the plane moves away from vertices. Larger: the cut is
/// less accurate. Smaller: slivers.
constexpr double kAwayFromVertices = 1e-3;

/// Closes the cut with flat lids. False where the cut has a hole, as that of an annulus.
bool putLids(TriangleMesh& mesh, const Eigen::Vector3d& up)
{
    const EdgeTable edges(mesh);
    for (const Rim& rim : findRims(edges))
    {
        Eigen::Vector3d area = Eigen::Vector3d::Zero();
        const Eigen::Vector3d& first = mesh.vertices[rim[0]];
        for (std::size_t k = 1; k + 1 < rim.size(); ++k)
        {
            area += (mesh.vertices[rim[k]] - first).cross(mesh.vertices[rim[k + 1]] - first);
        }
        const std::vector<Triangle> lid = clippedLid(mesh, edges, rim);
        if (area.dot(up) < 0 || lid.empty())
        {
            return false;
        }
        mesh.triangles.insert(mesh.triangles.end(), lid.begin(), lid.end());
    }
    return inspectMesh(mesh).closed();
}

/// Heights of the vertices above the plane, none of which is next to 0.
std::vector<double> heightsAbove(const TriangleMesh& mesh, const Eigen::Vector3d& up, double height)
{
    std::vector<double> above;
    double extent = 0;
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        above.push_back(up.dot(vertex) - height);
        extent = std::max(extent, std::abs(above.back()));
    }
    const double step = kAwayFromVertices * extent;
    const auto isNear = [&](double one) { return std::abs(one) < step / 2; };
    while (step > 0 && std::any_of(above.begin(), above.end(), isNear))
    {
        std::for_each(above.begin(), above.end(), [&](double& one) { one -= step; });
    }
    return above;
}

} // namespace

TriangleMesh cutBelow(const TriangleMesh& mesh, const Eigen::Vector3d& up, double height,
                      std::vector<std::size_t>& origins)
{
    constexpr std::uint32_t kNone = 0xFFFFFFFF;
    const std::vector<double> above = heightsAbove(mesh, up, height);
    TriangleMesh rest;
    std::vector<std::uint32_t> kept(mesh.vertices.size(), kNone);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings;
    const auto add = [&](const Eigen::Vector3d& place)
    {
        rest.vertices.push_back(place);
        return static_cast<std::uint32_t>(rest.vertices.size() - 1);
    };
    const auto crossing = [&](std::uint32_t from, std::uint32_t to)
    {
        const auto [low, high] = std::minmax(from, to);
        const auto [entry, isNew] = crossings.try_emplace({low, high}, kNone);
        if (isNew)
        {
            const double share = above[low] / (above[low] - above[high]);
            entry->second =
                add(mesh.vertices[low] + share * (mesh.vertices[high] - mesh.vertices[low]));
        }
        return entry->second;
    };
    origins.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const auto& triangle = mesh.triangles[t];
        std::vector<std::uint32_t> corners;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const std::uint32_t here = triangle[k];
            const std::uint32_t there = triangle[(k + 1) % 3];
            if (above[here] < 0)
            {
                kept[here] = kept[here] == kNone ? add(mesh.vertices[here]) : kept[here];
                corners.push_back(kept[here]);
            }
            if ((above[here] < 0) != (above[there] < 0))
            {
                corners.push_back(crossing(here, there));
            }
        }
        for (std::size_t k = 2; k < corners.size(); ++k)
        {
            rest.triangles.push_back({corners[0], corners[k - 1], corners[k]});
            origins.push_back(t);
        }
    }
    return !crossings.empty() && putLids(rest, up) ? rest : TriangleMesh();
}

BedContainer withoutHeadSpace(BedContainer container, const Eigen::Vector3d& up,
                              std::span<const Eigen::Vector3d> centres,
                              std::span<const double> radii)
{
    const double diameter = 2 * std::accumulate(radii.begin(), radii.end(), 0.0) /
                            static_cast<double>(std::max<std::size_t>(radii.size(), 1));
    double bed = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < radii.size(); ++k)
    {
        bed = std::max(bed, up.dot(centres[k]) + radii[k]);
    }
    double top = bed;
    for (const Eigen::Vector3d& vertex : container.mesh.vertices)
    {
        top = std::max(top, up.dot(vertex));
    }
    if (top > bed + 2 * diameter)
    {
        std::vector<std::size_t> origins;
        TriangleMesh rest = cutBelow(container.mesh, up, bed + diameter, origins);
        if (!rest.triangles.empty())
        {
            std::vector<std::uint32_t> partOf(rest.triangles.size(), BedContainer::kNoPart);
            for (std::size_t t = 0; t < origins.size() && !container.partOf.empty(); ++t)
            {
                partOf[t] = container.partOf[origins[t]];
            }
            return {std::move(rest), std::move(container.parts), std::move(partOf)};
        }
    }
    return container;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "shell/simplified_shell.hpp"

#include "shell/distance_bound.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace frostfill
{
namespace
{

/// Vertices in single precision, in a frame in which the mesh is as large as 1.
std::vector<float> unitPositions(const TriangleMesh& mesh, const Eigen::AlignedBox3d& box)
{
    std::vector<float> positions;
    positions.reserve(3 * mesh.vertices.size());
    const Eigen::Vector3d centre = box.center();
    const double size = box.sizes().maxCoeff();
    for (const Eigen::Vector3d& vertex : mesh.vertices)
    {
        const Eigen::Vector3f place = ((vertex - centre) / size).cast<float>();
        positions.insert(positions.end(), {place.x(), place.y(), place.z()});
    }
    return positions;
}

/// The mesh of these corners, without the vertices that none of them is.
TriangleMesh meshOf(const TriangleMesh& all, std::span<const std::uint32_t> corners)
{
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> renumbered(all.vertices.size(), kUnused);
    TriangleMesh mesh;
    for (std::size_t first = 0; first < corners.size(); first += 3)
    {
        std::array<std::uint32_t, 3>& triangle = mesh.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
        {
            std::uint32_t& number = renumbered[corners[first + k]];
            if (number == kUnused)
            {
                number = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(all.vertices[corners[first + k]]);
            }
            triangle[k] = number;
        }
    }
    return mesh;
}

/// Each true triangle, with the one that is nearest to its middle. A triangle of the shell that
/// stands for none so takes the one that is nearest to its own.
std::vector<std::array<std::uint32_t, 2>> pairTriangles(std::span<const std::uint32_t> onShown,
                                                        std::span<const std::uint32_t> onTrue)
{
    std::vector<std::array<std::uint32_t, 2>> pairs;
    std::vector<bool> hasOne(onTrue.size(), false);
    for (std::uint32_t t = 0; t < onShown.size(); ++t)
    {
        hasOne[onShown[t]] = true;
        pairs.push_back({onShown[t], t});
    }
    for (std::uint32_t shown = 0; shown < hasOne.size(); ++shown)
    {
        if (!hasOne[shown])
        {
            pairs.push_back({shown, onTrue[shown]});
        }
    }
    return pairs;
}

/// The shell, if the surfaces are nearer to each other than the limit.
std::optional<SimplifiedShell> judge(TriangleMesh&& shown, const TriangleMesh& mesh, double limit)
{
    const auto there = distanceBound(mesh, shown, limit);
    const auto back = there ? distanceBound(shown, mesh, limit) : std::nullopt;
    if (!back)
    {
        return std::nullopt;
    }
    const ShellInFile facts{shown.triangles.size(), mesh.triangles.size(),
                            std::max(there->distance, back->distance)};
    return SimplifiedShell{std::move(shown), facts, pairTriangles(there->nearest, back->nearest)};
}

SimplifiedShell trueShell(const TriangleMesh& mesh)
{
    return {mesh, {mesh.triangles.size(), mesh.triangles.size(), 0}, {}};
}

} // namespace

SimplifiedShell simplifyShell(const TriangleMesh& mesh, bool full)
{
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    if (full || mesh.triangles.size() <= kShellTriangles || !(box.sizes().maxCoeff() > 0))
    {
        return trueShell(mesh);
    }
    const double limit = kShellDistance * box.sizes().maxCoeff();
    const std::vector<float> positions = unitPositions(mesh, box);
    const std::span corners(mesh.triangles.front().data(), 3 * mesh.triangles.size());
    std::vector<std::uint32_t> fewer(corners.size());
    // The library bounds an estimate, so the true distance may be beyond it: then more are left.
    for (std::size_t target = kShellTriangles; target < mesh.triangles.size(); target *= 2)
    {
        const std::size_t count = meshopt_simplify(
            fewer.data(), corners.data(), corners.size(), positions.data(), mesh.vertices.size(),
            3 * sizeof(float), 3 * target, static_cast<float>(kShellDistance), 0, nullptr);
        if (count == 0 || count >= corners.size())
        {
            break;
        }
        if (auto shell = judge(meshOf(mesh, std::span(fewer).first(count)), mesh, limit))
        {
            return *std::move(shell);
        }
    }
    return trueShell(mesh);
}

void showPolygons(const SimplifiedShell& shell, std::span<const PolygonState> polygons,
                  std::vector<PolygonState>& shown)
{
    if (shell.isTrue())
    {
        shown.assign(polygons.begin(), polygons.end());
        return;
    }
    shown.assign(shell.mesh.triangles.size(), PolygonState::discarded);
    for (const auto& [stand, triangle] : shell.standsFor)
    {
        if (polygons[triangle] == PolygonState::active)
        {
            shown[stand] = PolygonState::active;
        }
    }
}

} // namespace frostfill

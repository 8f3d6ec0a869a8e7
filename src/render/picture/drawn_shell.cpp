// SPDX-License-Identifier: MIT
#include "render/picture/drawn_shell.hpp"

#include "mesh/triangle_shape.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

/// Estimated between the shell and the true mesh. Single points are up to three times as far.
constexpr double kMostPixels = 0.5;

} // namespace

DrawnShell::DrawnShell(const TriangleMesh& mesh, const RenderSettings& settings,
                       const Framing& framing, bool fadingLines)
    : height_(settings.size.height), isSeen_(settings.style.shell), fadingLines_(fadingLines)
{
    // With the edges of all triangles a picture shows the triangles themselves.
    const Style& style = settings.style;
    if (style.shell && !style.fullMesh && style.edges != EdgeLines::on &&
        mesh.triangles.size() > kShellTriangles)
    {
        dense_ = mesh;
        distance_ = wantedDistance(framing);
        use(simplifyWithin(dense_, distance_), framing);
    }
    else
    {
        use({mesh, {}, {}}, framing);
    }
    lookFrom(framing);
}

void DrawnShell::use(SimplifiedShell shell, const Framing& framing)
{
    shell_ = std::move(shell);
    states_.assign(shell_.mesh.triangles.size(), PolygonState::active);
    if (!isSeen_)
    {
        return;
    }
    std::vector<glm::vec3> normals(shell_.isTrue() ? 0 : shell_.mesh.triangles.size());
    for (const auto& [shown, triangle] : shell_.standsFor)
    {
        const auto& [a, b, c] = cornersOf(dense_, triangle);
        const Eigen::Vector3f normal = (b - a).cross(c - a).stableNormalized().cast<float>();
        normals[shown] += glm::vec3(normal.x(), normal.y(), normal.z());
    }
    for (glm::vec3& normal : normals)
    {
        normal /= std::max(glm::length(normal), 1e-6F);
    }
    shaded_ = shadeMesh(shell_.mesh, inUnitSpace(shell_.mesh, framing), fadingLines_, normals);
}

/// A power of two [unit space] as a length of the mesh, so that it seldom changes when the camera
/// moves; 0 for the true mesh.
double DrawnShell::wantedDistance(const Framing& framing) const
{
    if (dense_.triangles.empty())
    {
        return 0;
    }
    // Everything lies within 1 of the origin of unit space, and a turntable goes round the pivot.
    const double nearest =
        framing.orthographic ? 1 : framing.reach - 1 - glm::length(framing.pivot);
    const double pixelsPerUnit = framing.projection[1][1] * height_ / 2 / nearest;
    return nearest > 0
               ? std::exp2(std::floor(std::log2(kMostPixels / pixelsPerUnit))) / framing.scale
               : 0;
}

bool DrawnShell::lookFrom(const Framing& framing)
{
    const double wanted = wantedDistance(framing);
    const bool changes = std::exchange(distance_, wanted) != wanted;
    if (changes)
    {
        use(simplifyWithin(dense_, wanted), framing);
    }
    edges_ = edgeStrengths(shaded_, glm::vec3(framing.eye), framing.orthographic);
    return changes;
}

std::span<const std::uint32_t> DrawnShell::follow(std::span<const PolygonState> polygons)
{
    if (!shell_.isTrue() && !polygons.empty())
    {
        showPolygons(shell_, polygons, simplified_);
        polygons = simplified_;
    }
    changed_.clear();
    for (std::uint32_t t = 0; t < states_.size(); ++t)
    {
        const PolygonState now = t < polygons.size() ? polygons[t] : PolygonState::active;
        if (std::exchange(states_[t], now) != now)
        {
            changed_.push_back(t);
        }
    }
    return changed_;
}

} // namespace frostfill

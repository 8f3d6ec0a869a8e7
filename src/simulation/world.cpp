// SPDX-License-Identifier: MIT
#include <simulation/world.hpp>

namespace frostfill
{
namespace
{

/// Cells a radius wide: the lists of triangles stay short, and 27 of them hold every sphere near.
constexpr double kTriangleCell = 1;
constexpr double kTriangleReach = 1.5;
constexpr double kSphereCell = 2;

GridFrame gridOver(const Surface& surface, double cell)
{
    return GridFrame::cover(surface.box(), cell, 2);
}

} // namespace

World::World(const Scene& sceneOfRun, const TriangleMesh& mesh)
    : scene(sceneOfRun), report(inspectMesh(mesh)),
      frame(scene, report.box, sphereRadius(scene, report)), surface(frame.toRun(mesh)),
      triangles(surface, gridOver(surface, kTriangleCell), kTriangleReach),
      inside(surface, triangles), height(surface.box().sizes().y()),
      resting(gridOver(surface, kSphereCell)), polygons(mesh.triangles.size(), PolygonState::active)
{
    if (scene.spheres.count && !scene.spheres.untilFull)
    {
        targetCount = *scene.spheres.count;
    }
}

void World::freeze(std::uint32_t id)
{
    spheres.state[id] = SphereState::frozen;
    spheres.setVelocity(id, Eigen::Vector3d::Zero());
    resting.insert(id, spheres.position(id));
    ++restingCount;
    stateChanges.push_back(id);
}

void World::discard(std::uint32_t id)
{
    spheres.state[id] = SphereState::discarded;
    ++discardedCount;
    stateChanges.push_back(id);
}

void World::discardPolygon(std::uint32_t polygon)
{
    polygons[polygon] = PolygonState::discarded;
    ++discardedPolygons;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/world/frame_of_run.hpp"

#include <cmath>

namespace frostfill
{

FrameOfRun::FrameOfRun(const Scene& scene, const Eigen::AlignedBox3d& box, double radius)
    : origin(box.center()), length(radius)
{
    // Cyclic permutations keep the orientation of the triangles.
    switch (scene.object.up)
    {
    case Axis::x:
        axis = {2, 0, 1};
        break;
    case Axis::y:
        axis = {0, 1, 2};
        break;
    case Axis::z:
        axis = {1, 2, 0};
        break;
    }
    // Without gravity the unit of time is that of the Earth, so that speeds stay comparable.
    const double g = gravityInMeshUnits(scene);
    const double reference = g > 0 ? g : 9.81 * scene.object.unitsPerMetre;
    time = std::sqrt(radius / reference);
    gravity = g > 0 ? 1 : 0;
}

TriangleMesh FrameOfRun::toRun(const TriangleMesh& mesh) const
{
    TriangleMesh result = mesh;
    for (Eigen::Vector3d& vertex : result.vertices)
    {
        vertex = toRun(vertex);
    }
    return result;
}

} // namespace frostfill

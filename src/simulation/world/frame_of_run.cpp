// SPDX-License-Identifier: MIT
#include "simulation/world/frame_of_run.hpp"

#include "mesh/interior/mesh_size.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

using Box = Eigen::AlignedBox3d;

double cellsOf(const Eigen::Vector3d& size)
{
    return (size.array() + 2 * kGridMargin).prod();
}

/// Parts one beside the other in x, by the boxes where they are. Their middles are level, and that
/// of the row is the origin.
std::vector<MovedPart> rowOf(const std::vector<Box>& boxes)
{
    double length = -kGapOfParts;
    for (const Box& box : boxes)
    {
        length += kGapOfParts + box.sizes().x();
    }
    std::vector<MovedPart> row;
    double x = -length / 2;
    for (const Box& box : boxes)
    {
        const Eigen::Vector3d middle(x + box.sizes().x() / 2, 0, 0);
        x += box.sizes().x() + kGapOfParts;
        row.push_back({box, middle - box.center(), x - kGapOfParts / 2});
    }
    return row;
}

Eigen::Vector3d sizeOf(const std::vector<MovedPart>& row)
{
    Eigen::Vector3d size = Eigen::Vector3d::Zero();
    for (const MovedPart& part : row)
    {
        size = size.cwiseMax(part.box.sizes());
    }
    size.x() = 2 * row.back().end;
    return size;
}

} // namespace

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

FrameOfRun::FrameOfRun(const Scene& scene, const TriangleMesh& mesh, const Box& box, double radius)
    : FrameOfRun(scene, box, radius)
{
    const Eigen::Vector3d size = box.sizes() / length;
    // A part that moves away from the axis about which the object turns would feel other forces.
    if (cellsOf(size) <= kManyCells || scene.move.any())
    {
        return;
    }
    const std::vector<Box> boxes = separateBoxes(toRun(mesh), kGapOfParts);
    std::vector<MovedPart> row = rowOf(boxes);
    if (boxes.size() > 1 && kWorthMoving * cellsOf(sizeOf(row)) < cellsOf(size))
    {
        moved = std::move(row);
    }
}

const MovedPart& FrameOfRun::partAt(const Eigen::Vector3d& p) const
{
    const auto found = std::partition_point(
        moved.begin(), moved.end() - 1, [&](const MovedPart& part) { return part.end < p.x(); });
    return *found;
}

Eigen::Vector3d FrameOfRun::together(const Eigen::Vector3d& p) const
{
    const auto nearest = std::min_element(
        moved.begin(), moved.end(),
        [&](const MovedPart& a, const MovedPart& b)
        { return a.box.squaredExteriorDistance(p) < b.box.squaredExteriorDistance(p); });
    return p + nearest->shift;
}

} // namespace frostfill

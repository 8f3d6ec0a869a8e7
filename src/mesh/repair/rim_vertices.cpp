// SPDX-License-Identifier: MIT
#include "mesh/repair/rim_vertices.hpp"

#include "mesh/repair/weld.hpp"
#include "mesh/triangle_shape.hpp"

namespace frostfill
{
namespace
{

constexpr std::uint32_t kVerticesPerLeaf = 8;

std::vector<Triangle> trianglesOfRims(const TriangleMesh& mesh, const EdgeTable& edges)
{
    const std::vector<bool> onRim = verticesOnRims(mesh, edges);
    std::vector<Triangle> points;
    for (std::uint32_t vertex = 0; vertex < onRim.size(); ++vertex)
    {
        if (onRim[vertex])
        {
            points.push_back({vertex, vertex, vertex});
        }
    }
    return points;
}

} // namespace

RimVertices::RimVertices(const TriangleMesh& mesh, const EdgeTable& edges)
    : points_{mesh.vertices, trianglesOfRims(mesh, edges)}, tree_(points_, kVerticesPerLeaf)
{
    for (const TriangleTree::Node& node : tree_.nodes())
    {
        Eigen::AlignedBox3d& box = boxes_.emplace_back();
        for (const std::uint32_t point : tree_.triangles(node))
        {
            box.extend(points_.vertices[points_.triangles[point][0]]);
        }
    }
}

/// False only if the segment stays out of the box grown by `distance`.
bool RimVertices::mayTouch(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b, double distance)
{
    double first = 0;
    double last = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double low = box.min()[axis] - distance - a[axis];
        const double high = box.max()[axis] + distance - a[axis];
        const double along = b[axis] - a[axis];
        if (along == 0)
        {
            if (low > 0 || high < 0)
            {
                return false;
            }
            continue;
        }
        first = std::max(first, std::min(low / along, high / along));
        last = std::min(last, std::max(low / along, high / along));
    }
    return first <= last;
}

} // namespace frostfill

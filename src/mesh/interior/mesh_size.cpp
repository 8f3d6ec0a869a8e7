// SPDX-License-Identifier: MIT
#include <frostfill/mesh.hpp>

namespace frostfill
{

double signedVolume(const TriangleMesh& mesh)
{
    // Relative to the middle, so a small object far from the origin loses no digits.
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    const Eigen::Vector3d middle = box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.center();
    double sixfold = 0;
    for (const auto& t : mesh.triangles)
    {
        const Eigen::Vector3d a = mesh.vertices[t[0]] - middle;
        const Eigen::Vector3d b = mesh.vertices[t[1]] - middle;
        const Eigen::Vector3d c = mesh.vertices[t[2]] - middle;
        sixfold += a.dot(b.cross(c));
    }
    return sixfold / 6;
}

double surfaceArea(const TriangleMesh& mesh)
{
    double twice = 0;
    for (const auto& t : mesh.triangles)
    {
        const Eigen::Vector3d& a = mesh.vertices[t[0]];
        twice += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
    }
    return twice / 2;
}

Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const auto& t : mesh.triangles)
    {
        for (const std::uint32_t corner : t)
        {
            box.extend(mesh.vertices[corner]);
        }
    }
    return box;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "lab/meshes.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <utility>

namespace frostfill
{
TriangleMesh cutBoxMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int cuts)
{
    TriangleMesh mesh;
    const Eigen::Vector3d step = (high - low) / cuts;
    std::map<std::array<int, 3>, std::uint32_t> known; // of the lattice on the box's surface
    const auto vertex = [&](const std::array<int, 3>& corner)
    {
        const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
        const auto [entry, isNew] = known.emplace(corner, next);
        if (isNew)
        {
            Eigen::Vector3d p;
            for (int axis = 0; axis < 3; ++axis)
            {
                p[axis] = corner[axis] == cuts ? high[axis] : low[axis] + step[axis] * corner[axis];
            }
            mesh.vertices.push_back(p);
        }
        return entry->second;
    };
    for (int face = 0; face < 6; ++face)
    {
        for (int u = 0; u < cuts; ++u)
        {
            for (int v = 0; v < cuts; ++v)
            {
                const auto corner = [&](int du, int dv)
                {
                    std::array<int, 3> c{};
                    c[face / 2] = face % 2 * cuts;
                    c[(face / 2 + 1) % 3] = u + du;
                    c[(face / 2 + 2) % 3] = v + dv;
                    return vertex(c);
                };
                std::array<std::uint32_t, 4> q = {corner(0, 0), corner(1, 0), corner(1, 1),
                                                  corner(0, 1)};
                if (face % 2 == 0)
                {
                    std::swap(q[1], q[3]);
                }
                mesh.triangles.push_back({q[0], q[1], q[2]});
                mesh.triangles.push_back({q[0], q[2], q[3]});
            }
        }
    }
    return mesh;
}

TriangleMesh insideOut(TriangleMesh mesh)
{
    for (auto& triangle : mesh.triangles)
    {
        std::swap(triangle[1], triangle[2]);
    }
    return mesh;
}

TriangleMesh moved(TriangleMesh mesh, double scale, const Eigen::Matrix3d& rotation,
                   const Eigen::Vector3d& offset)
{
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = scale * (rotation * vertex) + offset;
    }
    return mesh;
}

} // namespace frostfill

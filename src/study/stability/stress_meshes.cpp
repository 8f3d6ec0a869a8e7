// SPDX-License-Identifier: MIT
#include "study/stability/stress_meshes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace frostfill
{
namespace
{

using Corner = std::array<int, 3>; ///< of the lattice on the box's surface

/// Gives each corner of the lattice one vertex.
class BoxVertices
{
public:
    BoxVertices(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int cuts,
                TriangleMesh& mesh)
        : low_(low), step_((high - low) / cuts), high_(high), cuts_(cuts), mesh_(mesh)
    {
    }

    std::uint32_t at(const Corner& corner)
    {
        const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
        const auto [entry, isNew] = known_.emplace(corner, next);
        if (isNew)
        {
            Eigen::Vector3d p;
            for (int axis = 0; axis < 3; ++axis)
            {
                p[axis] =
                    corner[axis] == cuts_ ? high_[axis] : low_[axis] + step_[axis] * corner[axis];
            }
            mesh_.vertices.push_back(p);
        }
        return entry->second;
    }

private:
    Eigen::Vector3d low_, step_, high_;
    int cuts_;
    TriangleMesh& mesh_;
    std::map<Corner, std::uint32_t> known_;
};

} // namespace

TriangleMesh boxMesh(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int cuts)
{
    TriangleMesh mesh;
    BoxVertices vertices(low, high, cuts, mesh);
    for (int face = 0; face < 6; ++face)
    {
        for (int u = 0; u < cuts; ++u)
        {
            for (int v = 0; v < cuts; ++v)
            {
                const auto corner = [&](int du, int dv)
                {
                    Corner c{};
                    c[face / 2] = face % 2 * cuts;
                    c[(face / 2 + 1) % 3] = u + du;
                    c[(face / 2 + 2) % 3] = v + dv;
                    return vertices.at(c);
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

TriangleMesh withSlivers(const TriangleMesh& mesh, double height)
{
    TriangleMesh cut;
    cut.vertices = mesh.vertices;
    for (const auto& [a, b, c] : mesh.triangles)
    {
        const Eigen::Vector3d middle = (mesh.vertices[a] + mesh.vertices[b]) / 2;
        const auto p = static_cast<std::uint32_t>(cut.vertices.size());
        cut.vertices.push_back(middle + height * (mesh.vertices[c] - middle));
        cut.triangles.push_back({a, b, p});
        cut.triangles.push_back({b, c, p});
        cut.triangles.push_back({c, a, p});
    }
    return cut;
}

TriangleMesh withDuplicates(TriangleMesh mesh, std::size_t count)
{
    for (std::size_t k = 0; k < count; ++k)
    {
        mesh.triangles.push_back(std::array(mesh.triangles[k]));
    }
    return mesh;
}

TriangleMesh withTJunctions(const TriangleMesh& mesh, std::size_t every)
{
    TriangleMesh cut;
    cut.vertices = mesh.vertices;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    {
        const auto& [a, b, c] = mesh.triangles[k];
        if (k % every != 0)
        {
            cut.triangles.push_back({a, b, c});
            continue;
        }
        const auto middle = static_cast<std::uint32_t>(cut.vertices.size());
        cut.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
        cut.triangles.push_back({a, middle, c});
        cut.triangles.push_back({middle, b, c});
    }
    return cut;
}

TriangleMesh insideOut(TriangleMesh mesh)
{
    for (auto& triangle : mesh.triangles)
    {
        std::swap(triangle[1], triangle[2]);
    }
    return mesh;
}

TriangleMesh needleCylinder(int sides)
{
    TriangleMesh mesh;
    for (int k = 0; k < sides; ++k)
    {
        const double angle = 2 * std::numbers::pi * k / sides;
        for (const double y : {-1.0, 1.0})
        {
            mesh.vertices.emplace_back(std::cos(angle), y, std::sin(angle));
        }
    }
    const auto at = [&](int k, int top)
    { return static_cast<std::uint32_t>(2 * (k % sides) + top); };
    for (int k = 0; k < sides; ++k)
    {
        mesh.triangles.push_back({at(k, 0), at(k, 1), at(k + 1, 1)});
        mesh.triangles.push_back({at(k, 0), at(k + 1, 1), at(k + 1, 0)});
        if (k == 0 || k + 1 == sides)
        {
            continue; // the caps are fans about the first vertex
        }
        mesh.triangles.push_back({at(0, 0), at(k, 0), at(k + 1, 0)});
        mesh.triangles.push_back({at(0, 1), at(k + 1, 1), at(k, 1)});
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

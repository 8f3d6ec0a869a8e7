// SPDX-License-Identifier: MIT
#include "physics/stress/stress_meshes.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace frostfill
{

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

} // namespace frostfill

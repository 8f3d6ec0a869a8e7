// SPDX-License-Identifier: MIT
#include "mesh_edit.hpp"

#include <algorithm>

namespace
{

constexpr double kFlattestFold = 0.7; // [1] cosine between the two faces of an edge that may flip
constexpr double kStride = 0.4;       // [1] part of the way to the neighbours' middle in a round

/// The corner of a face that is neither a nor b.
int oppositeCorner(const std::array<int, 3>& face, int a, int b)
{
    for (const int corner : face)
    {
        if (corner != a && corner != b)
        {
            return corner;
        }
    }
    return -1;
}

/// Flips edge (a, b) to (c, d) when that makes the worse of the two triangles better.
void flipIfBetter(MeshEdit& mesh, int a, int b)
{
    const std::vector<int> pair = mesh.facesAtEdge(a, b);
    if (pair.size() != 2)
    {
        return;
    }
    // Let `left` be the face that runs from a to b.
    const std::array<int, 3>& first = mesh.faces[pair[0]];
    const bool inOrder = (first[0] == a && first[1] == b) || (first[1] == a && first[2] == b) ||
                         (first[2] == a && first[0] == b);
    const int left = inOrder ? pair[0] : pair[1];
    const int right = inOrder ? pair[1] : pair[0];
    const int c = oppositeCorner(mesh.faces[left], a, b);
    const int d = oppositeCorner(mesh.faces[right], a, b);
    if (mesh.facesAround(a).size() < 4 || mesh.facesAround(b).size() < 4 ||
        !mesh.facesAtEdge(c, d).empty())
    {
        return;
    }

    const auto& v = mesh.vertices;
    const double before =
        std::min(triangleQuality(v[a], v[b], v[c]), triangleQuality(v[b], v[a], v[d]));
    const double after =
        std::min(triangleQuality(v[a], v[d], v[c]), triangleQuality(v[d], v[b], v[c]));
    if (after <= before + 1e-6)
    {
        return;
    }
    const Eigen::Vector3d old = mesh.cross(mesh.faces[left]).normalized();
    const Eigen::Vector3d other = mesh.cross(mesh.faces[right]).normalized();
    const Eigen::Vector3d one = mesh.cross({a, d, c}).normalized();
    const Eigen::Vector3d two = mesh.cross({d, b, c}).normalized();
    if (old.dot(other) < kFlattestFold || one.dot(two) < kFlattestFold ||
        one.dot(old + other) <= 0 || two.dot(old + other) <= 0)
    {
        return;
    }
    mesh.replaceCorner(left, b, d);
    mesh.replaceCorner(right, a, c);
}

void slide(MeshEdit& mesh, const Field& field, int vertex)
{
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const std::set<int> neighbours = mesh.neighbours(vertex);
    for (const int neighbour : neighbours)
    {
        middle += mesh.vertices[neighbour];
    }
    middle /= static_cast<double>(neighbours.size());
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const int face : mesh.facesAround(vertex))
    {
        normal += mesh.cross(mesh.faces[face]);
    }
    normal.normalize();

    const Eigen::Vector3d old = mesh.vertices[vertex];
    Eigen::Vector3d step = kStride * (middle - old);
    step -= step.dot(normal) * normal;
    const auto worst = [&]
    {
        double quality = 1;
        for (const int face : mesh.facesAround(vertex))
        {
            const std::array<int, 3>& f = mesh.faces[face];
            quality = std::min(quality, triangleQuality(mesh.vertices[f[0]], mesh.vertices[f[1]],
                                                        mesh.vertices[f[2]]));
        }
        return quality;
    };
    const double before = worst();
    mesh.vertices[vertex] = projectToSurface(field, old + step);
    if (worst() < before)
    {
        mesh.vertices[vertex] = old;
    }
}

} // namespace

void evenOut(Triangles& mesh, const Field& field, int rounds)
{
    MeshEdit edit(mesh);
    const int count = static_cast<int>(mesh.vertices.size());
    for (int round = 0; round < rounds; ++round)
    {
        for (int a = 0; a < count; ++a)
        {
            for (const int b : edit.neighbours(a))
            {
                if (a < b)
                {
                    flipIfBetter(edit, a, b);
                }
            }
        }
        for (int vertex = 0; vertex < count; ++vertex)
        {
            slide(edit, field, vertex);
        }
    }
    mesh = edit.finish();
}

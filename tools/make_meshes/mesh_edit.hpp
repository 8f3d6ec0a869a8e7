// SPDX-License-Identifier: MIT
#pragma once

#include "surface.hpp"

#include <algorithm>
#include <set>

/// A triangle mesh that knows its faces around each vertex, for edits that keep it manifold.
/// Faces that are gone have three equal corners.
class MeshEdit
{
public:
    explicit MeshEdit(const Triangles& mesh)
        : vertices(mesh.vertices), faces(mesh.faces), around_(mesh.vertices.size())
    {
        for (int face = 0; face < static_cast<int>(faces.size()); ++face)
        {
            for (const int corner : faces[face])
            {
                around_[corner].push_back(face);
            }
        }
    }

    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<int, 3>> faces;

    const std::vector<int>& facesAround(int vertex) const { return around_[vertex]; }

    static bool has(const std::array<int, 3>& face, int vertex)
    {
        return face[0] == vertex || face[1] == vertex || face[2] == vertex;
    }

    /// In ascending order.
    std::set<int> neighbours(int vertex) const
    {
        std::set<int> found;
        for (const int face : around_[vertex])
        {
            found.insert(faces[face].begin(), faces[face].end());
        }
        found.erase(vertex);
        return found;
    }

    std::vector<int> facesAtEdge(int a, int b) const
    {
        std::vector<int> found;
        for (const int face : around_[a])
        {
            if (has(faces[face], b))
            {
                found.push_back(face);
            }
        }
        return found;
    }

    /// Replaces a corner of a face and keeps the faces around both vertices up to date.
    void replaceCorner(int face, int from, int to)
    {
        std::replace(faces[face].begin(), faces[face].end(), from, to);
        std::erase(around_[from], face);
        around_[to].push_back(face);
    }

    void removeFace(int face)
    {
        for (const int corner : faces[face])
        {
            std::erase(around_[corner], face);
        }
        faces[face] = {0, 0, 0};
    }

    Eigen::Vector3d cross(const std::array<int, 3>& face) const
    {
        return (vertices[face[1]] - vertices[face[0]]).cross(vertices[face[2]] - vertices[face[0]]);
    }

    /// Without what is gone; vertices keep their order.
    Triangles finish() const
    {
        Triangles result;
        std::vector<int> place(vertices.size(), -1);
        for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex)
        {
            if (!around_[vertex].empty())
            {
                place[vertex] = static_cast<int>(result.vertices.size());
                result.vertices.push_back(vertices[vertex]);
            }
        }
        for (const std::array<int, 3>& face : faces)
        {
            if (face[0] != face[1])
            {
                result.faces.push_back({place[face[0]], place[face[1]], place[face[2]]});
            }
        }
        return result;
    }

private:
    std::vector<std::vector<int>> around_;
};

/// 1 for an equilateral triangle, 0 for one without area.
inline double triangleQuality(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c)
{
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return 2 * 1.7320508075688772 * (b - a).cross(c - a).norm() / squares;
}

// SPDX-License-Identifier: MIT
// Edge collapse by quadric error [Garland & Heckbert 1997], with the link condition
// [Dey et al. 1999], which keeps manifold and genus.
#include "mesh_edit.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

namespace
{

constexpr double kLengthWeight = 1e-3; // against needles where the surface is flat
constexpr double kWorstTurn = 0.3;     // [1] cosine of the largest turn of a face in a collapse
constexpr double kWorstQuality = 0.12; // [1] of a face after a collapse
constexpr double kLongestEdge = 0.085; // [m] so that flat parts keep enough triangles

class Decimation
{
public:
    Decimation(const Triangles& mesh, const Field& field)
        : mesh_(mesh), field_(field), quadrics_(mesh.vertices.size(), Eigen::Matrix4d::Zero()),
          left_(mesh.vertices.size())
    {
        for (const std::array<int, 3>& face : mesh_.faces)
        {
            const Eigen::Vector3d cross = mesh_.cross(face);
            const double area = cross.norm();
            if (area == 0)
            {
                continue;
            }
            Eigen::Vector4d plane;
            plane << cross / area, -cross.dot(mesh_.vertices[face[0]]) / area;
            for (const int corner : face)
            {
                quadrics_[corner] += area * plane * plane.transpose();
            }
        }
    }

    void reduceTo(std::size_t count)
    {
        std::size_t leftWhenOffered = left_ + 1;
        while (left_ > count)
        {
            if (queue_.empty())
            {
                // What was refused before may be possible now that its surroundings have changed.
                if (left_ == leftWhenOffered)
                {
                    throw std::runtime_error("no edge is left that may be collapsed");
                }
                leftWhenOffered = left_;
                offerAll();
                continue;
            }
            const auto [cost, a, b] = *queue_.begin();
            drop(a, b);
            tryCollapse(a, b);
        }
    }

    Triangles finish() const { return mesh_.finish(); }

private:
    using Candidate = std::tuple<double, int, int>;

    Eigen::Vector3d target(int a, int b) const
    {
        const Eigen::Matrix4d q = quadrics_[a] + quadrics_[b];
        const Eigen::Vector3d middle = 0.5 * (mesh_.vertices[a] + mesh_.vertices[b]);
        // A little of the midpoint makes the system regular on flat and on straight parts.
        const double pull = 1e-2 * q.topLeftCorner<3, 3>().trace();
        const Eigen::Matrix3d matrix = q.topLeftCorner<3, 3>() + pull * Eigen::Matrix3d::Identity();
        return matrix.ldlt().solve(pull * middle - q.topRightCorner<3, 1>());
    }

    void offerAll()
    {
        for (const std::array<int, 3>& face : mesh_.faces)
        {
            for (int i = 0; i < 3; ++i)
            {
                if (face[i] < face[(i + 1) % 3])
                {
                    offer(face[i], face[(i + 1) % 3]);
                }
            }
        }
    }

    void offer(int a, int b)
    {
        const double length = (mesh_.vertices[a] - mesh_.vertices[b]).squaredNorm();
        if (length > kLongestEdge * kLongestEdge)
        {
            return;
        }
        const Eigen::Vector4d point = target(a, b).homogeneous();
        const double error = point.dot((quadrics_[a] + quadrics_[b]) * point);
        const double cost = std::max(error, 0.0) + kLengthWeight * length * length;
        const auto edge = std::minmax(a, b);
        costs_[edge] = cost;
        queue_.emplace(cost, edge.first, edge.second);
    }

    void drop(int a, int b)
    {
        const auto edge = std::minmax(a, b);
        const auto known = costs_.find(edge);
        if (known == costs_.end())
        {
            return;
        }
        queue_.erase({known->second, edge.first, edge.second});
        costs_.erase(known);
    }

    bool keepsTopology(const std::set<int>& ofA, const std::set<int>& ofB) const
    {
        std::size_t common = 0;
        for (const int vertex : ofA)
        {
            common += ofB.count(vertex);
        }
        return common == 2 && ofA.size() + ofB.size() > 8;
    }

    bool keepsShape(int vertex, int other, const Eigen::Vector3d& point) const
    {
        for (const int face : mesh_.facesAround(vertex))
        {
            if (MeshEdit::has(mesh_.faces[face], other))
            {
                continue;
            }
            std::array<Eigen::Vector3d, 3> old;
            std::array<Eigen::Vector3d, 3> corners;
            for (int i = 0; i < 3; ++i)
            {
                old[i] = mesh_.vertices[mesh_.faces[face][i]];
                corners[i] = mesh_.faces[face][i] == vertex ? point : old[i];
            }
            const Eigen::Vector3d before = mesh_.cross(mesh_.faces[face]);
            const Eigen::Vector3d after = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            const double quality = triangleQuality(corners[0], corners[1], corners[2]);
            if (quality < std::min(kWorstQuality, triangleQuality(old[0], old[1], old[2])))
            {
                return false;
            }
            if (before.norm() > 1e-9 &&
                before.dot(after) < kWorstTurn * before.norm() * after.norm())
            {
                return false;
            }
        }
        return true;
    }

    void tryCollapse(int a, int b)
    {
        const std::set<int> ofA = mesh_.neighbours(a);
        const std::set<int> ofB = mesh_.neighbours(b);
        if (!keepsTopology(ofA, ofB))
        {
            return;
        }
        const Eigen::Vector3d point = projectToSurface(field_, target(a, b));
        if (!keepsShape(a, b, point) || !keepsShape(b, a, point))
        {
            return;
        }
        for (const int vertex : ofA)
        {
            drop(a, vertex);
        }
        for (const int vertex : ofB)
        {
            drop(b, vertex);
        }
        for (const int face : mesh_.facesAtEdge(a, b))
        {
            mesh_.removeFace(face);
        }
        const std::vector<int> moved = mesh_.facesAround(b);
        for (const int face : moved)
        {
            mesh_.replaceCorner(face, b, a);
        }
        mesh_.vertices[a] = point;
        quadrics_[a] += quadrics_[b];
        --left_;
        for (const int vertex : mesh_.neighbours(a))
        {
            offer(a, vertex);
        }
    }

    MeshEdit mesh_;
    const Field& field_;
    std::vector<Eigen::Matrix4d> quadrics_;
    std::size_t left_;
    std::set<Candidate> queue_; // ties are broken by vertex numbers
    std::map<std::pair<int, int>, double> costs_;
};

} // namespace

Triangles decimate(const Triangles& fine, const Field& field, std::size_t vertexCount)
{
    Triangles start = fine;
    for (Eigen::Vector3d& vertex : start.vertices)
    {
        vertex = projectToSurface(field, vertex);
    }
    Decimation decimation(start, field);
    decimation.reduceTo(vertexCount);
    return decimation.finish();
}

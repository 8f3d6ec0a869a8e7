// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_tree.hpp"

#include "mesh/interior/winding_number.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kFourPi = 12.566370614359172;

/// [1] Afar begins at this multiple of the radius of a node. Larger: 3 costs 1.4 times the time.
/// Smaller: the error grows. Measured up to a hundred edges from the surface: at most 0.055 on the
/// built-in objects, 0.051 on tubes that cross themselves, 0.022 on soups of tetrahedra, and 0.035
/// on a rough sphere, with 10,000 triangles as with 640,000 (0.089 at 2, 0.035 at 3).
constexpr double kFar = 2.5;

/// [unit^2] Smallest squared distance of a dipole. Smaller: its third power underflows, and the
/// quotient is no number.
constexpr double kMinSquare = 1e-180;

constexpr std::uint32_t kWindingLeafSize = 8; // triangles

} // namespace

WindingTree::WindingTree(const TriangleMesh& mesh) : mesh_(&mesh), tree_(mesh, kWindingLeafSize)
{
    dipoles_.reserve(tree_.nodes().size());
    for (const TriangleTree::Node& node : tree_.nodes())
    {
        dipoles_.push_back(dipoleOf(node));
    }
}

WindingTree::Dipole WindingTree::dipoleOf(const TriangleTree::Node& node) const
{
    Dipole dipole;
    Eigen::AlignedBox3d box;
    double area = 0;
    for (const std::uint32_t triangle : tree_.triangles(node))
    {
        const auto& t = mesh_->triangles[triangle];
        const Eigen::Vector3d& a = mesh_->vertices[t[0]];
        const Eigen::Vector3d& b = mesh_->vertices[t[1]];
        const Eigen::Vector3d& c = mesh_->vertices[t[2]];
        const Eigen::Vector3d twice = (b - a).cross(c - a);
        dipole.moment += twice / (2 * kFourPi);
        dipole.centre += twice.norm() * (a + b + c) / 3;
        area += twice.norm();
        box.extend(a).extend(b).extend(c);
    }
    // About the centre of the areas the next term of the series is small [Barill et al. 2018].
    dipole.centre = area > 0 ? Eigen::Vector3d(dipole.centre / area) : box.center();
    double squaredRadius = 0;
    for (const std::uint32_t triangle : tree_.triangles(node))
    {
        for (const std::uint32_t corner : mesh_->triangles[triangle])
        {
            squaredRadius =
                std::max(squaredRadius, (mesh_->vertices[corner] - dipole.centre).squaredNorm());
        }
    }
    dipole.farSquared = std::max(kFar * kFar * squaredRadius, kMinSquare);
    return dipole;
}

// The terms are few and each is at most 1/2, so a plain sum will do. Their order is that of the
// nodes. A node with the triangle to leave out is never afar, as p is on that triangle.
double WindingTree::sum(const Eigen::Vector3d& p, std::uint32_t without) const
{
    const std::span<const TriangleTree::Node> nodes = tree_.nodes();
    double sum = 0;
    for (std::size_t i = 0; i < nodes.size();)
    {
        const Dipole& dipole = dipoles_[i];
        const Eigen::Vector3d away = dipole.centre - p;
        const double square = away.squaredNorm();
        if (square > dipole.farSquared)
        {
            sum += away.dot(dipole.moment) / (square * std::sqrt(square));
            i = nodes[i].skip;
            continue;
        }
        if (tree_.isLeaf(i))
        {
            for (const std::uint32_t triangle : tree_.triangles(nodes[i]))
            {
                sum += triangle == without ? 0.0 : solidAngle(*mesh_, triangle, p);
            }
        }
        ++i;
    }
    return sum;
}

} // namespace frostfill

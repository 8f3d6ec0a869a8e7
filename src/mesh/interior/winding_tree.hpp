// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_tree.hpp"

#include <cstdint>
#include <vector>

namespace frostfill
{

/// The generalised winding number [Jacobson et al. 2013] in a time that grows with the logarithm of
/// the number of triangles: triangles that are far from the point count as one dipole
/// [Barill et al. 2018]. For a closed mesh the result is surely on the right side of kInsideFrom.
class WindingTree
{
public:
    /// `mesh` must outlive this object.
    explicit WindingTree(const TriangleMesh& mesh);

    /// Winding number of the mesh about p. Finite everywhere, but without meaning on the surface.
    [[nodiscard]] double at(const Eigen::Vector3d& p) const { return sum(p, kNoTriangle); }

    /// Winding number of the mesh without one triangle, about a point p of that triangle. It is the
    /// mean of the two sides: the one in front has 1/2 less, the one behind 1/2 more.
    [[nodiscard]] double at(const Eigen::Vector3d& p, std::uint32_t withoutTriangle) const
    {
        return sum(p, withoutTriangle);
    }

private:
    /// What the triangles of a node are from afar.
    struct Dipole
    {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        Eigen::Vector3d moment = Eigen::Vector3d::Zero(); ///< area times normal, over 4 pi
        double farSquared = 0; ///< squared distance from the centre where afar begins
    };

    static constexpr std::uint32_t kNoTriangle = 0xffffffff;

    [[nodiscard]] Dipole dipoleOf(const TriangleTree::Node& node) const;
    [[nodiscard]] double sum(const Eigen::Vector3d& p, std::uint32_t without) const;

    const TriangleMesh* mesh_;
    TriangleTree tree_;
    std::vector<Dipole> dipoles_; ///< [#nodes of tree_]
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_tree.hpp"

#include <optional>
#include <vector>

namespace frostfill
{

/// Finds the point of a mesh that is nearest to another, however far: a tree of boxes.
class NearestPoint
{
public:
    /// `mesh` must outlive this object.
    explicit NearestPoint(const TriangleMesh& mesh);

    /// Empty if no point of the mesh is nearer to p than `within`.
    [[nodiscard]] std::optional<Eigen::Vector3d> find(const Eigen::Vector3d& p,
                                                      double within) const;

private:
    struct Found
    {
        double square; ///< [unit^2] of the distance
        std::optional<Eigen::Vector3d> point;
    };
    void searchNode(std::size_t node, const Eigen::Vector3d& p, Found& found) const;

    const TriangleMesh* mesh_;
    TriangleTree tree_;
    std::vector<Eigen::AlignedBox3d> boxes_; ///< [#nodes of tree_]
};

} // namespace frostfill

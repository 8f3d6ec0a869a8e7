// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_bvh.hpp"

#include <cstdint>
#include <optional>
#include <utility>

namespace frostfill
{

/// Finds the point of a mesh that is nearest to another, however far.
class NearestPoint
{
public:
    /// `mesh` must outlive this object.
    explicit NearestPoint(const TriangleMesh& mesh) : mesh_(&mesh), bvh_(mesh) {}
    NearestPoint(const TriangleMesh& mesh, const TriangleTree& tree)
        : mesh_(&mesh), bvh_(mesh, tree)
    {
    }
    /// What it has of the mesh, for who needs the same.
    [[nodiscard]] TriangleBvh take() && { return std::move(bvh_); }

    [[nodiscard]] const TriangleMesh& mesh() const { return *mesh_; }

    struct Place
    {
        Eigen::Vector3d point;
        std::uint32_t triangle; ///< that has it; the first of several
        double distance;        ///< [unit]
    };
    /// Empty if no point of the mesh is nearer to p than `within`, which may be infinite.
    [[nodiscard]] std::optional<Place> find(const Eigen::Vector3d& p, double within) const;

private:
    const TriangleMesh* mesh_;
    TriangleBvh bvh_;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstdint>
#include <vector>

namespace frostfill
{

/// How far it is straight up to the next wall. The triangles are sorted into the cells of a grid
/// over the ground.
class Ceilings
{
public:
    /// `up` is an axis of the mesh, which lives as long as this.
    Ceilings(const TriangleMesh& mesh, const Eigen::Vector3d& up);

    /// [mesh unit] From p, in mesh coordinates, straight up to the mesh; 0 where nothing is above.
    [[nodiscard]] double above(const Eigen::Vector3d& p) const;

private:
    [[nodiscard]] int cell(double at, int axis) const;
    /// Height of the triangle over p; below p if it is not over it.
    [[nodiscard]] double heightOver(std::uint32_t triangle, const Eigen::Vector3d& p) const;

    const TriangleMesh& mesh_;
    int up_ = 1;             ///< axis
    int ground_[2] = {0, 2}; ///< the other two
    Eigen::AlignedBox3d box_;
    int count_ = 1;                     ///< cells along each axis of the ground
    std::vector<std::uint32_t> starts_; ///< [cells + 1] in triangles_
    std::vector<std::uint32_t> triangles_;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// The winding number of a closed mesh, exactly: a ray from the point counts the walls that it
/// leaves through, less those that it enters through. The triangles are sorted into columns along
/// the ray's axis, so a point asks those of one column.
class WindingColumns
{
public:
    /// `mesh` must outlive this object. It is closed, and may cross itself.
    explicit WindingColumns(const TriangleMesh& mesh);

    /// Of a point that is not on the surface; on it, that of one of the two sides.
    [[nodiscard]] int at(const Eigen::Vector3d& p) const;

private:
    [[nodiscard]] Eigen::Vector2d flat(const Eigen::Vector3d& p) const
    {
        return {p[across_[0]], p[across_[1]]};
    }
    /// The column of a coordinate, those beyond the border included.
    [[nodiscard]] int columnOf(double coordinate, std::size_t k) const;
    [[nodiscard]] int passage(const std::array<std::uint32_t, 3>& triangle,
                              const Eigen::Vector3d& p) const;

    const TriangleMesh* mesh_;
    Eigen::AlignedBox3d box_;
    std::array<int, 2> across_ = {1, 2}; ///< axes across the rays
    std::array<int, 2> count_ = {1, 1};  ///< of columns
    std::vector<std::uint32_t> starts_;  ///< [#columns + 1]
    std::vector<std::uint32_t> ids_;     ///< triangles by column
};

} // namespace frostfill

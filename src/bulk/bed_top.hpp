// SPDX-License-Identifier: MIT
// Room: where a bed of spheres ends, and its bulk: what is far from the walls and from that end.
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace frostfill
{

/// The surface of a bed: a level plane, or the height field of the topmost spheres. Over a place
/// the field is the highest top of the spheres whose axis passes within kReach of their radius. It
/// depends on the spheres alone, so a bed ends at the same surface in any container.
class BedTop
{
public:
    /// [radius] Smaller: the field falls into the gaps between the topmost spheres, of which those
    /// of a square lattice are 1.41 wide. Larger: the field rises above slopes.
    static constexpr double kReach = 1.5;

    /// A level plane at a coordinate along the axis `up`.
    BedTop(Eigen::Index up, double height) : up_(up), highest_(height) {}
    /// The height field of at least one sphere.
    BedTop(Eigen::Index up, std::span<const Eigen::Vector3d> centres,
           std::span<const double> radii);

    /// Coordinate of the surface over p; minus infinity where no sphere is near.
    [[nodiscard]] double over(const Eigen::Vector3d& p) const
    {
        if (tops_.empty())
        {
            return highest_;
        }
        std::array<std::ptrdiff_t, 2> cell;
        for (std::size_t k = 0; k < 2; ++k)
        {
            cell[k] = cellOf(p[across(k)], k);
            if (cell[k] < 0 || cell[k] >= counts_[k])
            {
                return -std::numeric_limits<double>::infinity();
            }
        }
        return tops_[static_cast<std::size_t>(cell[1] * counts_[0] + cell[0])];
    }
    /// How far p is below the surface, straight up; negative above it.
    [[nodiscard]] double depth(const Eigen::Vector3d& p) const { return over(p) - p[up_]; }
    [[nodiscard]] double highest() const { return highest_; }

private:
    [[nodiscard]] Eigen::Index across(std::size_t k) const
    {
        return (up_ + 1 + static_cast<Eigen::Index>(k)) % 3;
    }
    [[nodiscard]] std::ptrdiff_t cellOf(double coordinate, std::size_t k) const;
    void raise(const Eigen::Vector3d& centre, double radius);

    Eigen::Index up_;
    double highest_;
    std::array<double, 2> origin_ = {};
    double cell_ = 0;
    std::array<std::ptrdiff_t, 2> counts_ = {};
    std::vector<double> tops_; ///< [cells] empty: a plane
};

} // namespace frostfill

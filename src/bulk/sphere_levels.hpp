// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/grid_frame.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Spheres by where they are, those of like size together: in a level the largest is less than
/// twice as large as the smallest. So what is near a sphere is found in a time that grows with how
/// many there are, whatever the sizes.
class SphereLevels
{
public:
    SphereLevels(std::span<const Eigen::Vector3d> centres, std::span<const double> radii);

    struct Sphere
    {
        Eigen::Vector3d centre;
        double radius;
    };

    /// Of spheres of like size, sorted by the cells of a grid, x fastest.
    struct Level
    {
        double largest = 0; ///< radius
        GridFrame frame;
        std::vector<std::uint32_t> starts; ///< [#cells + 1]
        std::vector<Sphere> spheres;
        std::vector<std::uint32_t> ids; ///< of each in the lists

        /// Calls visit(first, end) for ranges of spheres that include all whose centre is within
        /// `reach` of p along each axis.
        template <class Visit>
        void forEachRange(const Eigen::Vector3d& p, double reach, Visit&& visit) const
        {
            const double far = reach * (1 + 1e-9) + 1e-9 * frame.cell; // rounding may take some
            const auto low = frame.coordinates(p.array() - far);
            const auto high = frame.coordinates(p.array() + far);
            for (int z = low[2]; z <= high[2]; ++z)
            {
                for (int y = low[1]; y <= high[1]; ++y)
                {
                    visit(starts[frame.index(low[0], y, z)],
                          starts[frame.index(high[0], y, z) + 1]);
                }
            }
        }
    };

    [[nodiscard]] std::span<const Level> levels() const { return levels_; }
    [[nodiscard]] double largestRadius() const { return levels_.back().largest; }
    /// Ids so that those side by side lie near each other.
    [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }

    /// Calls visit(id, centre, radius) for spheres, including all whose centre is within
    /// `reachOf(largest radius of a level)` of p.
    template <class ReachOf, class Visit>
    void forEachNear(const Eigen::Vector3d& p, ReachOf&& reachOf, Visit&& visit) const
    {
        for (const Level& level : levels_)
        {
            level.forEachRange(p, reachOf(level.largest),
                               [&](std::uint32_t first, std::uint32_t end)
                               {
                                   for (std::uint32_t k = first; k < end; ++k)
                                   {
                                       const Sphere& sphere = level.spheres[k];
                                       visit(level.ids[k], sphere.centre, sphere.radius);
                                   }
                               });
        }
    }

    /// Whether a sphere covers p.
    [[nodiscard]] bool covers(const Eigen::Vector3d& p) const;

private:
    std::vector<Level> levels_; ///< of ascending sizes
    std::vector<std::uint32_t> order_;
};

} // namespace frostfill

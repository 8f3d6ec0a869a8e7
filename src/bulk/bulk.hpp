// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "bulk/bed_top.hpp"
#include "bulk/sphere_levels.hpp"
#include "mesh/interior/inside_test.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

namespace frostfill
{

/// Distance from the walls and from the surface beyond which a bed is bulk [largest radius]: two
/// diameters, within which walls order spheres [Benenati & Brosilow 1962].
inline constexpr double kBulkBeyond = 4;
/// The same for users.
inline constexpr const char* kBulkInWords =
    "bulk: 4 r from the walls and from the surface, r being the largest radius";

/// Whether a place belongs to the bulk: inside the container, and so far from its wall and below
/// the surface of the bed, in the unit of the largest radius.
[[nodiscard]] inline bool isInBulk(double fromWall, double belowSurface, double largestRadius)
{
    return std::min(fromWall, belowSurface) >= kBulkBeyond * largestRadius;
}

/// Places that fill a box evenly as their numbers grow, shifted at random by each time.
[[nodiscard]] Eigen::Vector3d placeInBox(const Eigen::AlignedBox3d& box, std::uint64_t time,
                                         std::size_t number);

/// Packing fractions of the bulk in one container, counted at places that fill it evenly.
class Bulk
{
public:
    /// Finds the places that are far enough from walls for spheres up to this radius. Keeps none of
    /// the arguments.
    Bulk(const Surface& surface, const InsideTest& inside, Eigen::Index up, double largestRadius,
         Threads& threads);

    /// Whether any place is far enough from walls.
    [[nodiscard]] bool any() const { return places_.has_value(); }
    /// None where too few places are in the bulk: the object is too narrow, or next to empty.
    [[nodiscard]] std::optional<double> fraction(std::span<const Eigen::Vector3d> centres,
                                                 std::span<const double> radii) const;

private:
    Eigen::Index up_;
    double largestRadius_;
    std::optional<SphereLevels> places_; ///< as spheres of one size, to find those near a sphere
};

} // namespace frostfill

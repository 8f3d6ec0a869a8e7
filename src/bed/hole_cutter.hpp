// SPDX-License-Identifier: MIT
#pragma once

#include "bed/links.hpp"
#include "bed/wall_mesh.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace frostfill
{

/// Cuts the hole in which a bridge meets the wall.
class HoleCutter
{
public:
    HoleCutter(const Bed& bed, WallMesh& walls, const BedLink& link);

    /// The vertices of the hole's edge, from each corner of the bridge to the next. Empty where
    /// there is no room; the walls are then as they were.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> cut();

private:
    using Plane = Eigen::Vector2d; ///< across the axis

    [[nodiscard]] Plane across(const Eigen::Vector3d& p) const
    {
        return {right_.dot(p - centre_), forward_.dot(p - centre_)};
    }
    [[nodiscard]] double height(const Eigen::Vector3d& p) const
    {
        return link_.direction.dot(p - centre_);
    }
    [[nodiscard]] Plane across(std::uint32_t v) const { return across(walls_.vertex(v)); }
    [[nodiscard]] bool faces(std::uint32_t piece) const;
    [[nodiscard]] std::uint32_t find(const Plane& p, std::uint32_t from) const;
    [[nodiscard]] std::optional<std::uint32_t> addCorner(const Plane& p, std::uint32_t from);
    [[nodiscard]] bool drawEdge(std::uint32_t from, std::uint32_t to,
                                std::vector<std::uint32_t>& edge);
    [[nodiscard]] std::optional<std::uint32_t> cross(std::uint32_t from, std::uint32_t to);
    [[nodiscard]] bool isBelowSphere(std::uint32_t v) const;
    [[nodiscard]] bool isSeenFromSphere(const std::vector<std::uint32_t>& edge,
                                        std::uint32_t last) const;
    [[nodiscard]] bool openHole(std::uint32_t first, std::uint32_t second);
    [[nodiscard]] bool isSound() const;
    [[nodiscard]] bool isClear() const;
    [[nodiscard]] bool tryToCut(std::vector<std::vector<std::uint32_t>>& edges);

    const Bed& bed_;
    WallMesh& walls_;
    const BedLink& link_;
    Eigen::Vector3d centre_; ///< of the sphere
    Eigen::Vector3d right_;
    Eigen::Vector3d forward_;
    double start_;  ///< height at which the bridge leaves the sphere
    double margin_; ///< of heights
    double near_;   ///< distance in which two points across the axis are too near each other
};

} // namespace frostfill

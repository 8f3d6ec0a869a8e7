// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <span>

namespace frostfill
{

/// Cuts polygons into triangles with the same corners, n - 2 for n corners. A polygon that its
/// first corner sees wholly, as every convex one, becomes a fan around it. Any other loses its
/// ears, one after the other [Meisters 1975], in the plane of Newell's normal. A polygon that
/// crosses itself becomes triangles with the same rim.
class PolygonCutter
{
public:
    explicit PolygonCutter(const std::vector<Eigen::Vector3d>& vertices) : vertices_(vertices) {}

    /// Appends the triangles. Returns false, and appends no more, when ears have taken more time
    /// than a file may cost.
    [[nodiscard]] bool cut(std::span<const std::uint32_t> corners,
                           std::vector<std::array<std::uint32_t, 3>>& triangles);

private:
    struct Corner
    {
        std::uint32_t vertex = 0;
        std::uint32_t previous = 0; ///< place in ring_
        std::uint32_t next = 0;
        bool isReflex = false;
        Eigen::Vector2d position; ///< [1] of the polygon's extent, counter-clockwise
    };

    void layOut(std::span<const std::uint32_t> corners);
    [[nodiscard]] bool isFan() const;
    [[nodiscard]] double turnAt(const Corner& corner) const;
    void updateReflex(std::uint32_t at);
    [[nodiscard]] bool isEar(std::uint32_t at, int leniency);
    [[nodiscard]] bool blocks(const Corner& corner, const Corner& tip, bool onlyInside) const;
    void remove(std::uint32_t at);

    const std::vector<Eigen::Vector3d>& vertices_;
    std::vector<Corner> ring_;
    std::size_t left_ = 0;   ///< corners of the ring that no ear has taken
    std::size_t reflex_ = 0; ///< of them with more than 180 degrees
    std::uint64_t spent_ = 0;
    std::uint64_t allowed_ = 0;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The convex hull of points on a unit sphere, whose triangles are a Delaunay triangulation of them
/// [Brown 1979]. Points of a plane circle within which no other lies bound a face, which is cut
/// into triangles in some way. Points are added one by one, with exact signs.
class SphereHull
{
public:
    /// At least four points that are not in a plane. Throws std::logic_error for others.
    void build(std::span<const Eigen::Vector3d> points);

    using Face = std::array<std::uint32_t, 3>;
    /// Counter-clockwise seen from outside. Good until the next build().
    [[nodiscard]] std::span<const Face> faces() const { return faces_; }

private:
    struct Piece
    {
        Face corner;
        Face beyond; ///< pieces across the edges from each corner to the next
        bool isGone = false;
        std::uint32_t seenBy = 0;
    };

    void begin();
    void add(std::uint32_t point);
    [[nodiscard]] std::uint32_t visibleFrom(std::uint32_t point);
    [[nodiscard]] bool sees(std::uint32_t point, std::uint32_t piece) const;

    std::span<const Eigen::Vector3d> points_;
    std::vector<Piece> pieces_;
    std::vector<Face> faces_;
    // Of the point that is being added.
    std::vector<std::uint32_t> queue_;
    std::vector<std::uint32_t> seen_;
    std::vector<std::uint32_t> startsAt_; ///< [#points] the new piece whose edge starts there
    std::array<std::uint32_t, 4> first_{};
};

} // namespace frostfill

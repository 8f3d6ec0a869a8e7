// SPDX-License-Identifier: MIT
#pragma once

#include "bed/links.hpp"
#include "bed/sphere_hull.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill
{

using StlTriangle = std::array<Eigen::Vector3f, 3>;

/// Corners of a bridge's cross-section.
[[nodiscard]] std::uint32_t cornersOf(const Bed& bed, const BedLink& link);
/// Where a corner of a bridge is on one of its spheres [radius, from its centre].
[[nodiscard]] Eigen::Vector3d cornerOf(const Bed& bed, const BedLink& link, std::uint32_t sphere,
                                       std::uint32_t corner, std::uint32_t corners);
/// The same in the world, as STL has it.
[[nodiscard]] Eigen::Vector3f cornerInWorld(const Bed& bed, const BedLink& link,
                                            std::uint32_t sphere, std::uint32_t corner,
                                            std::uint32_t corners);

/// Makes the triangles of one sphere after another: wound into the sphere, all vertices within it.
///
/// The vertices are those of a geodesic sphere and, about each place that is flattened or where a
/// bridge begins, those of a circle; the triangles are those of their hull. Nothing lies beyond the
/// plane of a circle, so that its inside is a face of the hull: where a bridge begins it is left
/// out, and the bridge has the same corners. What walls and spheres cut off is taken away by moving
/// vertices towards the centre. That cannot make the surface cross itself, which every ray from the
/// centre meets once.
class SphereShape
{
public:
    SphereShape(const Bed& bed, const BedLinks& links, const TriangleMesh& geodesic)
        : bed_(bed), links_(links), geodesic_(geodesic)
    {
    }
    /// Appends the triangles of a sphere.
    void add(std::uint32_t sphere, std::vector<StlTriangle>& triangles);

private:
    struct Circle
    {
        Eigen::Vector3d direction;
        double cosine;      ///< of the angle within which there is no other point
        std::uint32_t link; ///< whose bridge begins there, or kFlat
    };
    struct Cut
    {
        Eigen::Vector3d direction;
        double distance; ///< [radius] from the centre
    };
    static constexpr std::uint32_t kFlat = 0xFFFFFFFF;
    static constexpr std::uint32_t kNoCircle = 0xFFFFFFFF;

    void look(std::uint32_t sphere);
    void addPlain(std::uint32_t sphere, std::vector<StlTriangle>& triangles) const;
    void addCircle(std::uint32_t sphere, std::uint32_t link, bool isBridge);
    [[nodiscard]] bool hasRoom(std::uint32_t sphere, std::uint32_t link, double wide) const;
    [[nodiscard]] double wide(std::uint32_t sphere, std::uint32_t link) const;

    const Bed& bed_;
    const BedLinks& links_;
    const TriangleMesh& geodesic_;
    SphereHull hull_;
    // Of the sphere at hand.
    std::vector<Circle> circles_;
    std::vector<Cut> cuts_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<std::uint32_t> circleOf_; ///< [#points]
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "bed/bed.hpp"

#include <cstddef>
#include <vector>

namespace frostfill
{

/// What is near in a bed, and what becomes of it.
struct BedLinks
{
    std::vector<BedLink> links;                       ///< by first, then by second
    std::vector<std::vector<std::uint32_t>> ofSphere; ///< [#S] links of each
    std::size_t bridged = 0;
    std::size_t thinned = 0;   ///< bridges that are thinner than asked: others are in the way
    std::size_t flattened = 0; ///< at walls, instead of bridged, or as asked

    /// The direction of a link as one of its spheres sees it.
    [[nodiscard]] Eigen::Vector3d direction(std::uint32_t link, std::uint32_t sphere) const
    {
        return links[link].first == sphere ? links[link].direction
                                           : Eigen::Vector3d(-links[link].direction);
    }
};

/// Finds what is nearer than the gap, and a radius for each bridge, so that no bridge meets another
/// one, a wall or a third sphere. Where spheres are near walls they are flattened. Throws Error
/// badData where spheres are not in the container, or overlap so far that no treatment parts them.
[[nodiscard]] BedLinks findLinks(const Bed& bed);

/// [radius of the sphere] how far from its centre it is flattened where a link is no bridge.
[[nodiscard]] double cutOf(const Bed& bed, const BedLink& link, std::uint32_t sphere);

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "bed/bed.hpp"

#include <cstddef>
#include <vector>

namespace frostfill
{

/// What is near in a bed, and is flattened.
struct BedLinks
{
    std::vector<BedLink> links;                       ///< by first, then by second
    std::vector<std::vector<std::uint32_t>> ofSphere; ///< [#S] links of each
};

/// Finds what is nearer than the gap. Throws Error badData where spheres are not in the container,
/// or overlap so far that no treatment parts them.
[[nodiscard]] BedLinks findLinks(const Bed& bed);

/// [radius of the sphere] how far from its centre it is flattened.
[[nodiscard]] double cutOf(const Bed& bed, const BedLink& link, std::uint32_t sphere);

} // namespace frostfill

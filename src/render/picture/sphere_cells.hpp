// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/sphere_instance.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// From so many spheres at rest on they are drawn by cells: to place and to order each of them for
/// every camera takes longer than to draw those that are seen.
inline constexpr std::size_t kCellsFrom = 100000;

/// Spheres that lie beside each other, and a sphere around them: if that is hidden, all are.
struct SphereCell
{
    std::uint32_t first, end; ///< indices of spheres
    SphereInstance around;
};

/// The order in which neighbours stand together, and those cells. Takes eight bytes a sphere while
/// it works.
struct CellOrder
{
    std::vector<std::uint32_t> order; ///< [spheres] which comes next
    std::vector<SphereCell> cells;    ///< of spheres in this order
};
[[nodiscard]] CellOrder orderByCells(std::span<const SphereInstance> spheres);

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"

#include <cstdint>
#include <span>

namespace frostfill
{

/// Pieces of wall that are beside a place: of those triangles the ones nearer than `reach`, and
/// farther than `onWall`, of which those that hang together at edges which are as near are one
/// piece. So the count does not depend on how finely a wall is divided.
[[nodiscard]] std::uint32_t wallPieces(const Surface& surface,
                                       std::span<const std::uint32_t> triangles,
                                       const Eigen::Vector3d& p, double reach, double onWall);

} // namespace frostfill

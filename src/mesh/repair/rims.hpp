// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/repair/edge_table.hpp"

namespace frostfill
{

using Rim = std::vector<std::uint32_t>; ///< vertices around a hole

/// The rims, in the direction of the lids, each without repeated vertices. A path that does not
/// close, because it ends at an edge of three triangles, is no rim.
[[nodiscard]] std::vector<Rim> findRims(const EdgeTable& edges);

} // namespace frostfill

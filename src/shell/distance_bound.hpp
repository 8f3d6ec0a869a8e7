// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace frostfill
{

struct DistanceBound
{
    /// How far points of the triangles of `from` are from the nearest ones of `to`, at most: the
    /// one-sided Hausdorff distance, or up to a tenth more, or limit/100 where that is more. [unit]
    double distance = 0;
    std::vector<std::uint32_t> nearest; ///< [#T of from] triangle of `to` nearest to the middle
};

/// Empty if the distance is not below `limit`. [unit]
[[nodiscard]] std::optional<DistanceBound> distanceBound(const TriangleMesh& from,
                                                         const TriangleMesh& to, double limit);

} // namespace frostfill

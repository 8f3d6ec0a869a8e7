// SPDX-License-Identifier: MIT
#pragma once

#include "bed/sphere_shape.hpp"

#include <array>
#include <span>
#include <vector>

namespace frostfill
{

/// The walls of a bed with holes where bridges end.
class WallHoles
{
public:
    /// Flattens where a wall has no room for a bridge.
    WallHoles(const Bed& bed, BedLinks& links);

    [[nodiscard]] std::span<const StlTriangle> triangles(BedPatch patch) const
    {
        return triangles_[static_cast<std::size_t>(patch)];
    }
    /// Appends the triangles of a bridge to a wall.
    void addBridge(std::uint32_t link, std::vector<StlTriangle>& triangles) const;

private:
    std::array<std::vector<StlTriangle>, kBedPatches.size()> triangles_;
};

} // namespace frostfill

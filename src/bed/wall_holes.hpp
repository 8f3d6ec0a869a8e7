// SPDX-License-Identifier: MIT
#pragma once

#include "bed/sphere_shape.hpp"
#include "bed/wall_mesh.hpp"

#include <array>
#include <span>
#include <vector>

namespace frostfill
{

/// The walls of a bed with holes where bridges end.
///
/// A bridge runs from a circle on its sphere along its axis to the wall. Its corners and edges are
/// added to the triangles that it meets there, and what they enclose is the hole. Where walls bend
/// within the circle, the bridge ends on all of them.
class WallHoles
{
public:
    /// Flattens where a wall has no room for a bridge.
    WallHoles(const Bed& bed, BedLinks& links);

    [[nodiscard]] std::span<const StlTriangle> triangles(BedPatch patch) const
    {
        return triangles_[static_cast<std::size_t>(patch)];
    }
    /// Appends the triangles of a bridge to a wall, which has a number among the links.
    void addBridge(const Bed& bed, const BedLink& link, std::uint32_t number,
                   std::vector<StlTriangle>& triangles) const;

private:
    /// Returns how many holes there are.
    std::size_t cutAll(const Bed& bed, BedLinks& links, WallMesh& walls);

    /// [#links] the hole's edge from each corner of a bridge to the next, the second one excluded.
    std::vector<std::vector<std::vector<Eigen::Vector3f>>> edges_;
    std::array<std::vector<StlTriangle>, kBedPatches.size()> triangles_;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"
#include "mesh/interior/triangle_grid.hpp"

#include <frostfill/scene.hpp>
#include <frostfill/snapshot.hpp>

#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

/// A polygon search: which polygons a running sphere is tested with in cycle 3 of Algorithm 1. It
/// is asked once a sphere and step. Preset paper.
class PolygonSearchPart
{
public:
    virtual ~PolygonSearchPart() = default;

    /// The active polygons that a sphere centred at p is to be tested with, ascending. Valid until
    /// the next call.
    [[nodiscard]] virtual std::span<const std::uint32_t> near(const Eigen::Vector3d& p) = 0;

    /// To be called after polygons have been discarded.
    virtual void update() {}
};

/// What is searched; all of it outlives the part.
struct SearchedPolygons
{
    const Surface& surface;
    const std::vector<PolygonState>& states;
    const TriangleGrid* grid = nullptr; ///< may be missing where the search does not need it
    /// How near to the edge of its part of space a centre may be to a polygon of the next and still
    /// has to be tested with it [r].
    double reach = 0;
};

[[nodiscard]] std::unique_ptr<PolygonSearchPart>
makePolygonSearch(PolygonSearch search, const SearchedPolygons& polygons);

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/triangle_grid.hpp"

#include <array>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace frostfill
{

/// Inside or outside in constant time, for a closed surface: cells without triangles are classified
/// once, points near the surface by the sign of the nearest triangle.
class InsideTest
{
public:
    /// Both live at least as long as this. The grid's frame encloses the surface by a margin of at
    /// least one cell.
    InsideTest(const Surface& surface, const TriangleGrid& grid);

    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const;

    /// Distance to the surface, positive inside, clamped to +- the grid's reach.
    [[nodiscard]] double distance(const Eigen::Vector3d& p) const;

    [[nodiscard]] double reach() const { return grid_->reach(); }

private:
    [[nodiscard]] bool isInsideFarFromSurface(const Eigen::Vector3d& p) const;
    void classifyFrom(const std::array<int, 3>& seed, std::vector<bool>& known);

    const Surface* surface_;
    const TriangleGrid* grid_;
    std::vector<bool> inside_; ///< [#cells] of those without triangles
    /// By cell, of points that are far from the surface in cells with triangles, once asked for.
    mutable std::unordered_map<std::size_t, bool> farSides_;
    std::unique_ptr<std::mutex> farSidesLock_ = std::make_unique<std::mutex>();
};

} // namespace frostfill

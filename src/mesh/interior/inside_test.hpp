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

/// Whether a point is inside a closed surface, in constant time. Cells without triangles are
/// classified once. Near the surface, the sign of the nearest triangle decides.
class InsideTest
{
public:
    /// Both arguments must outlive this object. The frame of the grid encloses the surface with a
    /// margin of at least one cell.
    InsideTest(const Surface& surface, const TriangleGrid& grid);

    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const;

    /// Distance to the surface, positive inside, clamped to +- the reach of the grid.
    [[nodiscard]] double distance(const Eigen::Vector3d& p) const;

    [[nodiscard]] double reach() const { return grid_->reach(); }

private:
    [[nodiscard]] bool isInsideFarFromSurface(const Eigen::Vector3d& p) const;
    void classifyFrom(const std::array<int, 3>& seed, std::vector<bool>& known);

    const Surface* surface_;
    const TriangleGrid* grid_;
    std::vector<bool> inside_; ///< [#cells] valid for cells without triangles
    /// For cells with triangles: the side of the points far from the surface, once requested.
    mutable std::unordered_map<std::size_t, bool> farSides_;
    std::unique_ptr<std::mutex> farSidesLock_ = std::make_unique<std::mutex>();
};

} // namespace frostfill

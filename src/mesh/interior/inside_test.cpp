// SPDX-License-Identifier: MIT
#include "mesh/interior/inside_test.hpp"

#include <algorithm>

namespace frostfill
{

// The nearest triangle of the list is the nearest of all if it is within the reach of the list.
double InsideTest::distance(const Eigen::Vector3d& p, double atMost) const
{
    const std::span<const std::uint32_t> triangles = grid_->near(p);
    if (triangles.empty())
    {
        return isInsideByWinding(p) ? reach() : -reach();
    }
    const SignedDistance nearest = grid_->nearest(p, triangles, atMost);
    const double distance = std::min(std::abs(nearest.value), reach());
    return contains(p, nearest) ? distance : -distance;
}

bool InsideTest::isNearTwoSided(const Eigen::Vector3d& p) const
{
    const auto isTwoSided = [this](std::uint32_t id) { return (*surface_)[id].twoSided; };
    if (!surface_->anyTwoSided())
    {
        return false;
    }
    const std::span<const std::uint32_t> all = grid_->near(p);
    if (all.size() <= TriangleGrid::kShortList)
    {
        return std::any_of(all.begin(), all.end(), isTwoSided);
    }
    bool isNear = false; // once one is, the others of its leaf come, too
    surface_->tree().forEachTriangleNear(p, reach(),
                                         [&](std::uint32_t id)
                                         {
                                             isNear = isTwoSided(id) || isNear;
                                             return isNear ? -1 : reach();
                                         });
    return isNear;
}

} // namespace frostfill

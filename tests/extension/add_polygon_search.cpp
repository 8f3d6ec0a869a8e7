// SPDX-License-Identifier: MIT
#include "simulation/paper/polygon_search.hpp"

#include <algorithm>
#include <limits>

namespace frostfill
{
namespace
{

/// The polygons at the height of the sphere.
class ByHeight final : public PolygonSearchPart
{
public:
    explicit ByHeight(const SearchedPolygons& polygons) : states_(polygons.states)
    {
        for (std::uint32_t polygon = 0; polygon < polygons.surface.size(); ++polygon)
        {
            Extent extent;
            for (const Eigen::Vector3d& corner : polygons.surface[polygon].corner)
            {
                extent.low = std::min(extent.low, corner.y() - polygons.reach);
                extent.high = std::max(extent.high, corner.y() + polygons.reach);
            }
            extents_.push_back(extent);
        }
    }
    void search(const Eigen::Vector3d& p, PolygonVisitor& visit) const override
    {
        const double y = p.y(); // the visitor may move p
        for (std::uint32_t polygon = 0; polygon < extents_.size(); ++polygon)
        {
            const Extent& extent = extents_[polygon];
            if (y >= extent.low && y <= extent.high && states_[polygon] == PolygonState::active)
            {
                visit(polygon);
            }
        }
    }

private:
    struct Extent
    {
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();
    };
    const std::vector<PolygonState>& states_;
    std::vector<Extent> extents_; ///< heights of spheres that are tested with it
};

[[maybe_unused]] const PolygonSearch kByHeight =
    polygonSearches().add("by-height", [](const SearchedPolygons& polygons)
                          { return std::make_unique<ByHeight>(polygons); });

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/paper/polygon_search.hpp"

namespace frostfill
{

void PolygonList::append(std::uint32_t polygon)
{
    // Appended in ascending order and read in ascending order, like the plain loop.
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({polygon, kEnd});
    if (node == 0)
    {
        head_ = 0;
    }
    else
    {
        nodes_[node - 1].next = node;
    }
}

void PolygonList::unlinkDiscarded(const std::vector<PolygonState>& states)
{
    std::uint32_t* link = &head_;
    while (*link != kEnd)
    {
        Node& node = nodes_[*link];
        if (states[node.polygon] == PolygonState::discarded)
        {
            *link = node.next;
        }
        else
        {
            link = &node.next;
        }
    }
}

PolygonTests::PolygonTests(PolygonSearch search, const Surface& surface,
                           const std::vector<PolygonState>& states, double reach,
                           const TriangleGrid* grid)
    : search_(search), states_(&states), grid_(grid), centre_(surface.box().center())
{
    const Eigen::Vector3d size = surface.box().sizes();
    int shortest = 0;
    size.minCoeff(&shortest);
    axes_ = {(shortest + 1) % 3, (shortest + 2) % 3};

    for (std::uint32_t polygon = 0; polygon < surface.size(); ++polygon)
    {
        if (search == PolygonSearch::list)
        {
            list_.append(polygon);
        }
        if (search != PolygonSearch::quadtree)
        {
            continue;
        }
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& corner : surface[polygon].corner)
        {
            box.extend(corner);
        }
        // A quarter takes every polygon that one of its spheres may touch, so some are in several.
        for (std::size_t part = 0; part < 4; ++part)
        {
            bool near = true;
            for (int k = 0; k < 2; ++k)
            {
                const int axis = axes_[k];
                const bool upper = (part >> k & 1u) != 0;
                near = near && (upper ? box.max()[axis] + reach >= centre_[axis]
                                      : box.min()[axis] - reach <= centre_[axis]);
            }
            if (near)
            {
                quarters_[part].push_back(polygon);
            }
        }
    }
}

void PolygonTests::update()
{
    list_.unlinkDiscarded(*states_);
    for (std::vector<std::uint32_t>& quarter : quarters_)
    {
        std::erase_if(quarter, [this](std::uint32_t polygon)
                      { return (*states_)[polygon] == PolygonState::discarded; });
    }
}

} // namespace frostfill

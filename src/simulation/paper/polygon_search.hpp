// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"
#include "mesh/interior/triangle_grid.hpp"

#include <frostfill/scene.hpp>
#include <frostfill/snapshot.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// Polygons in a singly linked list, from which discarded ones are unlinked (PAPER: step 5).
class PolygonList
{
public:
    void append(std::uint32_t polygon);
    void unlinkDiscarded(const std::vector<PolygonState>& states);

    template <class Visit>
    void forEach(Visit&& visit) const
    {
        for (std::uint32_t node = head_; node != kEnd; node = nodes_[node].next)
        {
            visit(nodes_[node].polygon);
        }
    }

private:
    static constexpr std::uint32_t kEnd = 0xffffffff;
    struct Node
    {
        std::uint32_t polygon;
        std::uint32_t next;
    };
    std::vector<Node> nodes_;
    std::uint32_t head_ = kEnd;
};

/// Which polygons a sphere is tested with. PAPER: all that are left in a loop or a linked list, or
/// those of the quarter of the mesh that the sphere is in (the paper's "Quad Tree"). Ours: those of
/// its cell of a uniform grid.
class PolygonTests
{
public:
    /// Everything given outlives this. `reach`: how near to its quarter's edge a sphere's centre
    /// may be to a polygon of the next quarter and still has to be tested with it. Only
    /// PolygonSearch::grid needs a `grid`.
    PolygonTests(PolygonSearch search, const Surface& surface,
                 const std::vector<PolygonState>& states, double reach,
                 const TriangleGrid* grid = nullptr);

    /// Calls visit(polygon) for each active polygon that a sphere centred at p is to be tested
    /// with.
    template <class Visit>
    void forEach(const Eigen::Vector3d& p, Visit&& visit) const
    {
        switch (search_)
        {
        case PolygonSearch::loop:
            for (std::uint32_t polygon = 0; polygon < states_->size(); ++polygon)
            {
                if ((*states_)[polygon] == PolygonState::active)
                {
                    visit(polygon);
                }
            }
            return;
        case PolygonSearch::list:
            list_.forEach(visit);
            return;
        case PolygonSearch::quadtree:
            for (const std::uint32_t polygon : quarters_[quarter(p)])
            {
                visit(polygon);
            }
            return;
        case PolygonSearch::grid:
            for (const std::uint32_t polygon : grid_->near(p))
            {
                if ((*states_)[polygon] == PolygonState::active)
                {
                    visit(polygon);
                }
            }
            return;
        }
    }

    /// To be called after polygons have been discarded.
    void update();

private:
    [[nodiscard]] std::size_t quarter(const Eigen::Vector3d& p) const
    {
        return (p[axes_[0]] >= centre_[axes_[0]] ? 1u : 0u) +
               (p[axes_[1]] >= centre_[axes_[1]] ? 2u : 0u);
    }

    PolygonSearch search_;
    const std::vector<PolygonState>* states_;
    const TriangleGrid* grid_;
    PolygonList list_;
    std::array<std::vector<std::uint32_t>, 4> quarters_; ///< ascending; active ones only
    Eigen::Vector3d centre_;
    std::array<int, 2> axes_ = {0, 1}; ///< the two longest of the box, which are halved
};

} // namespace frostfill

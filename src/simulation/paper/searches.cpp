// SPDX-License-Identifier: MIT
#include "simulation/paper/searches.hpp"

#include "simulation/paper/tolerances.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace frostfill
{

namespace
{

void eraseDiscarded(std::vector<std::uint32_t>& polygons, const std::vector<PolygonState>& states)
{
    std::erase_if(polygons, [&](std::uint32_t polygon)
                  { return states[polygon] == PolygonState::discarded; });
}

/// PAPER: all that are left, in a loop over all.
class Loop final : public PolygonSearchPart
{
public:
    explicit Loop(const SearchedPolygons& polygons)
        : states_(polygons.states), left_(polygons.states.size())
    {
        std::iota(left_.begin(), left_.end(), std::uint32_t{0});
        eraseDiscarded(left_, states_);
    }
    std::span<const std::uint32_t> near(const Eigen::Vector3d&) override { return left_; }
    void update() override { eraseDiscarded(left_, states_); }

private:
    const std::vector<PolygonState>& states_;
    std::vector<std::uint32_t> left_;
};

/// PAPER: all that are left, in a singly linked list from which discarded ones are unlinked (step
/// 5).
class List final : public PolygonSearchPart
{
public:
    explicit List(const SearchedPolygons& polygons)
        : states_(polygons.states), left_(polygons.states.size())
    {
        // Appended in ascending order and read in ascending order, like the plain loop.
        for (std::uint32_t polygon = 0; polygon < polygons.surface.size(); ++polygon)
        {
            nodes_.push_back({polygon, polygon + 1});
        }
        if (!nodes_.empty())
        {
            head_ = 0;
            nodes_.back().next = kEnd;
        }
    }
    std::span<const std::uint32_t> near(const Eigen::Vector3d&) override
    {
        std::size_t count = 0;
        for (std::uint32_t node = head_; node != kEnd; node = nodes_[node].next)
        {
            left_[count++] = nodes_[node].polygon;
        }
        return std::span(left_).first(count);
    }
    void update() override
    {
        std::uint32_t* link = &head_;
        while (*link != kEnd)
        {
            Node& node = nodes_[*link];
            if (states_[node.polygon] == PolygonState::discarded)
            {
                *link = node.next;
            }
            else
            {
                link = &node.next;
            }
        }
    }

private:
    static constexpr std::uint32_t kEnd = 0xffffffff;
    struct Node
    {
        std::uint32_t polygon;
        std::uint32_t next;
    };
    const std::vector<PolygonState>& states_;
    std::vector<Node> nodes_;
    std::uint32_t head_ = kEnd;
    std::vector<std::uint32_t> left_; ///< as read from the list last
};

/// PAPER, "Quad Tree": those of the quarter of the mesh that the sphere is in.
class Quadtree final : public PolygonSearchPart
{
public:
    explicit Quadtree(const SearchedPolygons& polygons)
        : states_(polygons.states), centre_(polygons.surface.box().center())
    {
        const Eigen::Vector3d size = polygons.surface.box().sizes();
        int shortest = 0;
        size.minCoeff(&shortest);
        axes_ = {(shortest + 1) % 3, (shortest + 2) % 3};
        for (std::uint32_t polygon = 0; polygon < polygons.surface.size(); ++polygon)
        {
            Eigen::AlignedBox3d box;
            for (const Eigen::Vector3d& corner : polygons.surface[polygon].corner)
            {
                box.extend(corner);
            }
            sortIn(polygon, box, polygons.reach);
        }
    }
    std::span<const std::uint32_t> near(const Eigen::Vector3d& p) override
    {
        return quarters_[quarter(p)];
    }
    void update() override
    {
        for (std::vector<std::uint32_t>& quarter : quarters_)
        {
            eraseDiscarded(quarter, states_);
        }
    }

private:
    // A quarter takes every polygon that one of its spheres may touch, so some are in several.
    void sortIn(std::uint32_t polygon, const Eigen::AlignedBox3d& box, double reach)
    {
        for (std::size_t part = 0; part < 4; ++part)
        {
            bool near = true;
            for (int k = 0; k < 2; ++k)
            {
                const int axis = axes_[static_cast<std::size_t>(k)];
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
    [[nodiscard]] std::size_t quarter(const Eigen::Vector3d& p) const
    {
        return (p[axes_[0]] >= centre_[axes_[0]] ? 1u : 0u) +
               (p[axes_[1]] >= centre_[axes_[1]] ? 2u : 0u);
    }

    const std::vector<PolygonState>& states_;
    std::array<std::vector<std::uint32_t>, 4> quarters_; ///< ascending; active ones only
    Eigen::Vector3d centre_;
    std::array<int, 2> axes_ = {0, 1}; ///< the two longest of the box, which are halved
};

/// Those of the sphere's cell of a uniform grid.
class PolygonsByGrid final : public PolygonSearchPart
{
public:
    explicit PolygonsByGrid(const SearchedPolygons& polygons)
        : states_(polygons.states), grid_(*polygons.grid)
    {
    }
    std::span<const std::uint32_t> near(const Eigen::Vector3d& p) override
    {
        const std::span<const std::uint32_t> all = grid_.near(p, grid_.reach(), found_);
        active_.assign(all.begin(), all.end());
        eraseDiscarded(active_, states_);
        return active_;
    }

private:
    const std::vector<PolygonState>& states_;
    const TriangleGrid& grid_;
    std::vector<std::uint32_t> found_;
    std::vector<std::uint32_t> active_;
};

} // namespace

std::unique_ptr<PolygonSearchPart> makePolygonSearch(PolygonSearch search,
                                                     const SearchedPolygons& polygons)
{
    switch (search)
    {
    case PolygonSearch::list:
        return std::make_unique<List>(polygons);
    case PolygonSearch::quadtree:
        return std::make_unique<Quadtree>(polygons);
    case PolygonSearch::grid:
        return std::make_unique<PolygonsByGrid>(polygons);
    case PolygonSearch::loop:
        break;
    }
    return std::make_unique<Loop>(polygons);
}

} // namespace frostfill

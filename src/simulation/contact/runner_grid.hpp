// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/bricked_cells.hpp"
#include "geometry/grid_frame.hpp"
#include "simulation/contact/tolerances.hpp"
#include "simulation/world/running_spheres.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace frostfill
{

/// Running spheres by cell, by row, as they lay when it was built, and as they are told to it
/// since. Filling and emptying cost what the runners cost, not the cells.
class RunnerGrid
{
public:
    explicit RunnerGrid(const GridFrame& frame)
        : frame_(frame), cells_(frame.count), head_(cells_.size(), kEnd)
    {
    }

    /// Forgets all and takes in these, as they lie now.
    void rebuild(const RunningSpheres& runners)
    {
        for (const Node& node : nodes_)
        {
            head_[node.cell] = kEnd;
        }
        nodes_.clear();
        ++buildCount_;
        for (std::uint32_t row = 0; row < runners.size(); ++row)
        {
            add(runners.position[row], runners.radius[row]);
        }
    }

    /// How often it has been built.
    [[nodiscard]] std::uint64_t buildCount() const { return buildCount_; }

    /// Takes in one more runner, with the next row.
    void add(const Eigen::Vector3d& p, double radius)
    {
        nodes_.push_back({p, radius, kEnd, 0});
        link(static_cast<std::uint32_t>(nodes_.size() - 1));
    }

    /// To be called when a runner has been put elsewhere.
    void move(std::uint32_t row, const Eigen::Vector3d& p)
    {
        std::uint32_t* entry = &head_[nodes_[row].cell];
        while (*entry != row)
        {
            entry = &nodes_[*entry].next;
        }
        *entry = nodes_[row].next;
        nodes_[row].position = p;
        link(row);
    }

    /// Whether a sphere at the place would touch no runner.
    [[nodiscard]] bool isClear(const Eigen::Vector3d& place, double radius) const
    {
        bool clear = true;
        const double reach = radius + 1 + kClearance;
        cells_.forEachIn(frame_.coordinates(place.array() - reach),
                         frame_.coordinates(place.array() + reach),
                         [&](std::size_t cell)
                         {
                             for (std::uint32_t row = head_[cell]; clear && row != kEnd;)
                             {
                                 const Node& node = nodes_[row];
                                 const double contact = node.radius + radius + kClearance;
                                 clear = (node.position - place).squaredNorm() >= contact * contact;
                                 row = node.next;
                             }
                         });
        return clear;
    }

    /// Calls visit(row, position, radius) for each runner in the cells that a cube of half-edge
    /// `reach` about p meets, in no particular order.
    template <class Visit>
    void forEachNear(const Eigen::Vector3d& p, double reach, Visit&& visit) const
    {
        cells_.forEachIn(frame_.coordinates(p.array() - reach),
                         frame_.coordinates(p.array() + reach),
                         [&](std::size_t cell)
                         {
                             for (std::uint32_t row = head_[cell]; row != kEnd;)
                             {
                                 const Node& node = nodes_[row];
                                 visit(row, node.position, node.radius);
                                 row = node.next;
                             }
                         });
    }

private:
    /// A runner, with all that a search needs in one place of memory.
    struct Node
    {
        Eigen::Vector3d position;
        double radius;
        std::uint32_t next;
        std::uint32_t cell;
    };

    void link(std::uint32_t row)
    {
        Node& node = nodes_[row];
        const auto [x, y, z] = frame_.coordinates(node.position);
        const std::size_t cell = cells_.obtain(x, y, z);
        if (cell >= head_.size())
        {
            head_.resize(cells_.size(), kEnd);
        }
        node.cell = static_cast<std::uint32_t>(cell);
        node.next = std::exchange(head_[node.cell], row);
    }

    static constexpr std::uint32_t kEnd = 0xffffffff;
    GridFrame frame_;
    BrickedCells<> cells_;
    std::vector<std::uint32_t> head_; ///< [#cells_]
    std::vector<Node> nodes_;         ///< [#runners]
    std::uint64_t buildCount_ = 0;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/grid_frame.hpp"
#include "simulation/contact/runner.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Runners by cell, by their index. Filling and emptying cost what the runners cost, not the cells.
class RunnerGrid
{
public:
    explicit RunnerGrid(const GridFrame& frame) : frame_(frame), head_(frame.size(), kEnd) {}

    /// Forgets all and takes in these, as they lie now.
    void rebuild(std::span<const Runner> runners)
    {
        for (const std::uint32_t cell : cell_)
        {
            head_[cell] = kEnd;
        }
        cell_.clear();
        nodes_.clear();
        for (const Runner& runner : runners)
        {
            add(runner.position, runner.radius);
        }
    }

    /// Takes in one more runner, with the next index.
    void add(const Eigen::Vector3d& p, double radius)
    {
        cell_.push_back(0);
        nodes_.push_back({p, radius, kEnd});
        link(static_cast<std::uint32_t>(cell_.size() - 1), p);
    }

    /// To be called when a runner has been put elsewhere.
    void move(std::uint32_t index, const Eigen::Vector3d& p)
    {
        std::uint32_t* entry = &head_[cell_[index]];
        while (*entry != index)
        {
            entry = &nodes_[*entry].next;
        }
        *entry = nodes_[index].next;
        nodes_[index].position = p;
        link(index, p);
    }

    /// Calls visit(index, position, radius) for each runner in the cells that a cube of half-edge
    /// `reach` about p meets, in no particular order.
    template <class Visit>
    void forEachNear(const Eigen::Vector3d& p, double reach, Visit&& visit) const
    {
        frame_.forEachCell(frame_.coordinates(p.array() - reach),
                           frame_.coordinates(p.array() + reach),
                           [&](std::size_t cell)
                           {
                               for (std::uint32_t index = head_[cell]; index != kEnd;)
                               {
                                   const Node& node = nodes_[index];
                                   visit(index, node.position, node.radius);
                                   index = node.next;
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
    };

    void link(std::uint32_t index, const Eigen::Vector3d& p)
    {
        const auto cell = static_cast<std::uint32_t>(frame_.index(p));
        cell_[index] = cell;
        nodes_[index].next = head_[cell];
        head_[cell] = index;
    }

    static constexpr std::uint32_t kEnd = 0xffffffff;
    GridFrame frame_;
    std::vector<std::uint32_t> head_; ///< [#cells]
    std::vector<Node> nodes_;         ///< [#runners]
    std::vector<std::uint32_t> cell_; ///< [#runners]
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <geometry/grid_frame.hpp>
#include <simulation/spheres.hpp>

#include <cstdint>
#include <vector>

namespace frostfill
{

/// Spheres by cell, as linked lists. Cells are at least as large as the largest distance asked for.
class SphereGrid
{
public:
    explicit SphereGrid(const GridFrame& frame) : frame_(frame), head_(frame.size(), kEnd) {}

    void insert(std::uint32_t id, const Eigen::Vector3d& p)
    {
        if (next_.size() <= id)
        {
            next_.resize(id + 1, kEnd);
        }
        const std::size_t cell = frame_.index(p);
        next_[id] = head_[cell];
        head_[cell] = id;
    }

    /// Takes out a sphere that was inserted at p.
    void remove(std::uint32_t id, const Eigen::Vector3d& p)
    {
        std::uint32_t* link = &head_[frame_.index(p)];
        while (*link != id)
        {
            link = &next_[*link];
        }
        *link = next_[id];
    }

    /// Calls visit(id) for each sphere in the cells that a cube of half-edge `reach` about p meets.
    template <class Visit>
    void forEachNear(const Eigen::Vector3d& p, double reach, Visit&& visit) const
    {
        const auto low = frame_.coordinates(p.array() - reach);
        const auto high = frame_.coordinates(p.array() + reach);
        for (int z = low[2]; z <= high[2]; ++z)
        {
            for (int y = low[1]; y <= high[1]; ++y)
            {
                for (int x = low[0]; x <= high[0]; ++x)
                {
                    for (std::uint32_t id = head_[frame_.index(x, y, z)]; id != kEnd;
                         id = next_[id])
                    {
                        visit(id);
                    }
                }
            }
        }
    }

    [[nodiscard]] const GridFrame& frame() const { return frame_; }

private:
    static constexpr std::uint32_t kEnd = 0xffffffff;
    GridFrame frame_;
    std::vector<std::uint32_t> head_; ///< [#cells]
    std::vector<std::uint32_t> next_; ///< [#S]
};

} // namespace frostfill

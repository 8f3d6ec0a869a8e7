// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/grid_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace frostfill
{

/// A sphere of a grid, with all that a search needs in one place of memory.
struct GridSphere
{
    double x = 0, y = 0, z = 0;
    double radius = 0;
    std::uint32_t next = 0;
    bool discarded = false; ///< nothing can touch it any more

    [[nodiscard]] Eigen::Vector3d position() const { return {x, y, z}; }
};

/// Spheres that do not move, by cell, as linked lists. Cells are at least as large as the largest
/// distance asked for.
class SphereGrid
{
public:
    explicit SphereGrid(const GridFrame& frame) : frame_(frame), head_(frame.size(), kEnd) {}

    void insert(std::uint32_t id, const Eigen::Vector3d& p, double radius)
    {
        if (spheres_.size() <= id)
        {
            spheres_.resize(id + 1);
        }
        std::uint32_t& head = head_[frame_.index(p)];
        spheres_[id] = {p.x(), p.y(), p.z(), radius, head, false};
        head = id;
        extent_.extend(p);
    }

    /// Room for so many spheres without moving any in memory.
    void reserve(std::size_t count) { spheres_.reserve(count); }

    /// Takes out a sphere that was inserted.
    void remove(std::uint32_t id)
    {
        std::uint32_t* link = &head_[frame_.index(spheres_[id].position())];
        while (*link != id)
        {
            link = &spheres_[*link].next;
        }
        *link = spheres_[id].next;
    }

    [[nodiscard]] const GridSphere& operator[](std::uint32_t id) const { return spheres_[id]; }
    void setDiscarded(std::uint32_t id, bool discarded) { spheres_[id].discarded = discarded; }

    /// Calls visit(id) for each sphere in the cells that a ball of radius `reach` about p meets,
    /// and maybe for a few more.
    template <class Visit>
    void forEachNear(const Eigen::Vector3d& p, double reach, Visit&& visit) const
    {
        if (extent_.squaredExteriorDistance(p) > reach * reach)
        {
            return; // a fall begins far above all that is at rest
        }
        const auto low = frame_.coordinates(p.array() - reach);
        const auto high = frame_.coordinates(p.array() + reach);
        for (int z = low[2]; z <= high[2]; ++z)
        {
            const double dz = distanceToLayer(p, 2, z);
            for (int y = low[1]; y <= high[1]; ++y)
            {
                const double dy = distanceToLayer(p, 1, y);
                if (dz * dz + dy * dy <= reach * reach)
                {
                    forEachIn({low[0], y, z}, {high[0], y, z}, visit);
                }
            }
        }
    }

    /// Calls visit(id) for each sphere in the cells from `low` to `high`, both included.
    template <class Visit>
    void forEachIn(const std::array<int, 3>& low, const std::array<int, 3>& high,
                   Visit&& visit) const
    {
        frame_.forEachCell(low, high,
                           [&](std::size_t cell)
                           {
                               for (std::uint32_t id = head_[cell]; id != kEnd;
                                    id = spheres_[id].next)
                               {
                                   visit(id);
                               }
                           });
    }

    [[nodiscard]] const GridFrame& frame() const { return frame_; }

private:
    /// From p to the nearest point of a layer of cells. Layers at the border reach to infinity.
    [[nodiscard]] double distanceToLayer(const Eigen::Vector3d& p, int axis, int layer) const
    {
        const double low = frame_.origin[axis] + frame_.cell * layer;
        const double below = layer > 0 ? low - p[axis] : 0;
        const double above = layer + 1 < frame_.count[axis] ? p[axis] - (low + frame_.cell) : 0;
        return std::max({0.0, below, above});
    }

    static constexpr std::uint32_t kEnd = 0xffffffff;
    GridFrame frame_;
    std::vector<std::uint32_t> head_; ///< [#cells]
    Eigen::AlignedBox3d extent_;      ///< of all that were ever inserted
    std::vector<GridSphere> spheres_; ///< [#S] those inserted; the others' values mean nothing
};

} // namespace frostfill

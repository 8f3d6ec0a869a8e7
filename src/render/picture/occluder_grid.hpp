// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/sphere_instance.hpp"

#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Spheres that are found by their places; they have indices in the order in which they were added.
/// Those that were there when the grid was last built lie in cells, row by row, so that neighbours
/// are read one after another; those that have come since are few, and in a list.
class OccluderGrid
{
public:
    void start(std::span<const SphereInstance> spheres);
    void add(const SphereInstance& sphere);

    [[nodiscard]] std::size_t size() const { return spheres_.size(); }
    /// Centre and radius.
    [[nodiscard]] const glm::vec4& operator[](std::size_t sphere) const { return spheres_[sphere]; }
    /// No sphere has a larger radius.
    [[nodiscard]] float largest() const { return largest_; }
    /// Index of one of the same place and size; the number of spheres if there is none.
    [[nodiscard]] std::size_t indexOf(const SphereInstance& sphere) const;
    /// Calls visit(index) for the spheres whose centres are in cells that a box touches and that
    /// mayHold(middle, half diagonal) does not rule out; and for others nearby.
    template <typename MayHold, typename Visit>
    void eachIn(const glm::vec3& lowest, const glm::vec3& highest, MayHold mayHold,
                Visit visit) const
    {
        const glm::ivec3 low = placeOf(lowest);
        const glm::ivec3 high = placeOf(highest);
        const float halfDiagonal = 0.8661F * cell_;
        for (int z = low.z; z <= high.z; ++z)
        {
            for (int y = low.y; y <= high.y; ++y)
            {
                const auto mayHoldAt = [&](int x)
                {
                    const glm::vec3 middle = corner_ + (glm::vec3(x, y, z) + 0.5F) * cell_;
                    return mayHold(middle, halfDiagonal);
                };
                int first = low.x;
                int last = high.x;
                for (; first <= last && !mayHoldAt(first); ++first)
                {
                }
                for (; last > first && !mayHoldAt(last); --last)
                {
                }
                const std::size_t row = rowOf(y, z);
                for (std::uint32_t k = begins_[row + static_cast<std::size_t>(first)];
                     first <= last && k < begins_[row + static_cast<std::size_t>(last) + 1]; ++k)
                {
                    visit(inCells_[k]);
                }
            }
        }
        for (std::size_t i = inCells_.size(); i < spheres_.size(); ++i)
        {
            visit(static_cast<std::uint32_t>(i));
        }
    }

private:
    /// The cell of a point, or the one nearest to it. [cells]
    [[nodiscard]] glm::ivec3 placeOf(const glm::vec3& point) const;
    [[nodiscard]] std::size_t rowOf(int y, int z) const;
    [[nodiscard]] std::size_t cellOf(std::size_t sphere) const;
    void build();

    float largest_ = 0;
    glm::vec3 corner_{0};
    float cell_ = 1;                          ///< edge of the cells
    glm::ivec3 cells_{1};                     ///< along each axis
    std::vector<glm::vec4> spheres_;          ///< centre, radius
    std::vector<std::uint32_t> begins_{0, 0}; ///< [cells + 1] in inCells_
    std::vector<std::uint32_t> inCells_;      ///< indices of spheres by cells
};

} // namespace frostfill

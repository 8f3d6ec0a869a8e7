// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/sphere_instance.hpp"

#include <glm/ext/vector_int3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Spheres that are found by their places; they have indices in the order in which they were added.
class OccluderGrid
{
public:
    void add(const SphereInstance& sphere);

    [[nodiscard]] std::span<const SphereInstance> spheres() const { return spheres_; }
    /// No sphere has a larger radius.
    [[nodiscard]] float largest() const { return largest_; }
    /// Index of one of the same place and size; the number of spheres if there is none.
    [[nodiscard]] std::size_t indexOf(const SphereInstance& sphere) const;
    /// Calls visit(index) for the spheres whose centres are in cells that a box touches and that
    /// mayHold(middle, half diagonal) does not rule out.
    template <typename MayHold, typename Visit>
    void eachIn(const glm::vec3& lowest, const glm::vec3& highest, MayHold mayHold,
                Visit visit) const
    {
        const glm::ivec3 low = placeOf(lowest);
        const glm::ivec3 high = placeOf(highest);
        const float halfDiagonal = 0.8661F * cell_;
        for (int z = low.z; !spheres_.empty() && z <= high.z; ++z)
        {
            for (int y = low.y; y <= high.y; ++y)
            {
                for (int x = low.x; x <= high.x; ++x)
                {
                    const glm::ivec3 place(x, y, z);
                    if (mayHold((glm::vec3(place) + 0.5F) * cell_, halfDiagonal))
                    {
                        visitCell(place, visit);
                    }
                }
            }
        }
    }

private:
    [[nodiscard]] std::uint32_t cellOf(const glm::ivec3& place) const;
    [[nodiscard]] glm::ivec3 placeOf(const glm::vec3& point) const;
    void rebuild();
    void enter(std::uint32_t sphere);
    template <typename Visit>
    void visitCell(const glm::ivec3& place, Visit& visit) const
    {
        for (std::uint32_t i = heads_[cellOf(place)]; i != 0; i = nexts_[i - 1])
        {
            if (cells_[i - 1] == place)
            {
                visit(i - 1);
            }
        }
    }

    float largest_ = 0;
    float cell_ = 1; ///< edge of the cells
    std::vector<SphereInstance> spheres_;
    std::vector<glm::ivec3> cells_;    ///< [spheres]
    std::vector<std::uint32_t> heads_; ///< of the cells' lists, hashed; index + 1, or 0
    std::vector<std::uint32_t> nexts_; ///< [spheres]
};

} // namespace frostfill

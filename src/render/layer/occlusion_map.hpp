// SPDX-License-Identifier: MIT
#pragma once

#include "render/picture/projected_sphere.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The furthest depth in each small block of a picture. What is further in all the blocks that it
/// can be seen in is hidden, and stays so for as long as nothing is taken away and the camera is
/// still.
class OcclusionMap
{
public:
    OcclusionMap(int width, int height);

    /// From now on nothing is hidden.
    void clear() { known_ = false; }
    /// Takes the depths of a part of the picture, in which all lie that hide: 24 bits above 8 that
    /// do not count, bottom row first.
    void build(const PixelRectangle& part, std::span<const std::uint32_t> depths);
    [[nodiscard]] bool hides(const ProjectedSphere& sphere) const;

private:
    int columns_;
    bool known_ = false;
    std::vector<float> furthest_;          ///< [rows x columns]
    std::vector<std::int32_t> ofBlockRow_; ///< [columns] the same, as integers
};

} // namespace frostfill

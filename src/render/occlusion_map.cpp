// SPDX-License-Identifier: MIT
#include "occlusion_map.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace frostfill
{
namespace
{

/// Edge of a block [pixel]. Smaller ones know more of small spheres and take longer to ask.
constexpr int kBlock = 4;

constexpr int blocks(int pixels)
{
    return (pixels + kBlock - 1) / kBlock;
}

} // namespace

OcclusionMap::OcclusionMap(int width, int height)
    : width_(width), height_(height), columns_(blocks(width)),
      furthest_(static_cast<std::size_t>(blocks(width) * blocks(height)))
{
}

void OcclusionMap::build(const std::vector<float>& depth)
{
    assert(depth.size() == static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    std::fill(furthest_.begin(), furthest_.end(), 0.0F);
    for (int y = 0; y < height_; ++y)
    {
        const float* row =
            depth.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
        float* block = furthest_.data() + static_cast<std::ptrdiff_t>(y / kBlock) * columns_;
        int x = 0;
        for (; x + kBlock <= width_; x += kBlock, row += kBlock, ++block)
        {
            *block = std::max(*block, std::max(std::max(row[0], row[1]), std::max(row[2], row[3])));
        }
        for (; x < width_; ++x, ++row)
        {
            *block = std::max(*block, *row);
        }
    }
    known_ = true;
}

bool OcclusionMap::hides(const ProjectedSphere& sphere) const
{
    if (!known_ || sphere.pixels.empty())
    {
        return false;
    }
    const int right = (sphere.pixels.right - 1) / kBlock;
    const int top = (sphere.pixels.top - 1) / kBlock;
    for (int y = sphere.pixels.bottom / kBlock; y <= top; ++y)
    {
        const float* row = furthest_.data() + static_cast<std::ptrdiff_t>(y) * columns_;
        for (int x = sphere.pixels.left / kBlock; x <= right; ++x)
        {
            if (row[x] >= sphere.nearestDepth)
            {
                return false;
            }
        }
    }
    return true;
}

} // namespace frostfill

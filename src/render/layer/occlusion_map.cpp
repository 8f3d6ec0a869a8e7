// SPDX-License-Identifier: MIT
#include "render/layer/occlusion_map.hpp"

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
    : columns_(blocks(width)), furthest_(static_cast<std::size_t>(blocks(width) * blocks(height)))
{
}

void OcclusionMap::build(const PixelRectangle& part, std::span<const std::uint32_t> depths)
{
    assert(depths.size() == static_cast<std::size_t>(part.area()));
    known_ = true;
    // Blocks that are not all in the part hide nothing.
    const int firstColumn = blocks(part.left);
    const int columns = part.right / kBlock - firstColumn;
    std::fill(furthest_.begin(), furthest_.end(), 1.0F);
    if (columns <= 0)
    {
        return;
    }
    ofBlockRow_.resize(static_cast<std::size_t>(columns));
    for (int blockRow = blocks(part.bottom); blockRow < part.top / kBlock; ++blockRow)
    {
        std::fill(ofBlockRow_.begin(), ofBlockRow_.end(), 0);
        for (int y = blockRow * kBlock; y < (blockRow + 1) * kBlock; ++y)
        {
            const std::uint32_t* row = depths.data() +
                                       static_cast<std::ptrdiff_t>(y - part.bottom) * part.width() +
                                       (firstColumn * kBlock - part.left);
            for (std::int32_t& furthest : ofBlockRow_)
            {
                // Signed, for which every processor has a maximum of several at once.
                const auto depth = [&](int x) { return static_cast<std::int32_t>(row[x] >> 8); };
                furthest = std::max(
                    furthest, std::max(std::max(depth(0), depth(1)), std::max(depth(2), depth(3))));
                row += kBlock;
            }
        }
        float* to =
            furthest_.data() + static_cast<std::ptrdiff_t>(blockRow) * columns_ + firstColumn;
        for (const std::int32_t furthest : ofBlockRow_)
        {
            *to++ = static_cast<float>(furthest / double{0xffffff});
        }
    }
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

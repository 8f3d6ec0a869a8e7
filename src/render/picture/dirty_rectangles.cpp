// SPDX-License-Identifier: MIT
#include "render/picture/dirty_rectangles.hpp"

#include <cstddef>

namespace frostfill
{
namespace
{

/// Pixels whose renewal costs as much as the calls for one more rectangle.
constexpr std::int64_t kCallCost = 2500;

/// With more rectangles than this, looking for pairs costs more than it saves.
constexpr std::size_t kMaxRectangles = 256;

bool worthJoining(const PixelRectangle& a, const PixelRectangle& b)
{
    return a.overlaps(b) || around(a, b).area() <= a.area() + b.area() + kCallCost;
}

/// One sweep over all pairs; returns whether any was joined.
bool joinPairs(std::vector<PixelRectangle>& rectangles)
{
    bool changed = false;
    for (std::size_t i = 0; i < rectangles.size(); ++i)
    {
        for (std::size_t k = i + 1; k < rectangles.size();)
        {
            if (!worthJoining(rectangles[i], rectangles[k]))
            {
                ++k;
                continue;
            }
            rectangles[i] = around(rectangles[i], rectangles[k]);
            rectangles[k] = rectangles.back();
            rectangles.pop_back();
            changed = true;
        }
    }
    return changed;
}

} // namespace

void DirtyRectangles::add(const PixelRectangle& rectangle)
{
    const PixelRectangle inside = common(rectangle, picture_);
    if (!inside.empty())
    {
        rectangles_.push_back(inside);
    }
}

void DirtyRectangles::add(std::span<const PixelRectangle> rectangles)
{
    for (const PixelRectangle& rectangle : rectangles)
    {
        add(rectangle);
    }
}

void DirtyRectangles::addAll()
{
    rectangles_.assign(1, picture_);
}

const std::vector<PixelRectangle>& DirtyRectangles::joined()
{
    if (rectangles_.size() > kMaxRectangles)
    {
        PixelRectangle all;
        for (const PixelRectangle& rectangle : rectangles_)
        {
            all = around(all, rectangle);
        }
        rectangles_.assign(1, all);
    }
    while (joinPairs(rectangles_))
    {
    }
    return rectangles_;
}

} // namespace frostfill

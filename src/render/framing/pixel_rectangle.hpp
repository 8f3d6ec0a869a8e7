// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace frostfill
{

/// Pixels left..right-1, bottom..top-1 of the picture. As in OpenGL, y grows upwards.
struct PixelRectangle
{
    int left = 0;
    int bottom = 0;
    int right = 0;
    int top = 0;

    [[nodiscard]] bool empty() const { return left >= right || bottom >= top; }
    [[nodiscard]] int width() const { return right - left; }
    [[nodiscard]] int height() const { return top - bottom; }
    [[nodiscard]] std::int64_t area() const
    {
        return empty() ? 0 : std::int64_t{width()} * height();
    }
    [[nodiscard]] bool overlaps(const PixelRectangle& other) const
    {
        return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }
    friend bool operator==(const PixelRectangle&, const PixelRectangle&) = default;
};

/// The smallest rectangle around both. An empty one counts as nothing.
[[nodiscard]] inline PixelRectangle around(const PixelRectangle& a, const PixelRectangle& b)
{
    if (a.empty() || b.empty())
    {
        return a.empty() ? b : a;
    }
    return {std::min(a.left, b.left), std::min(a.bottom, b.bottom), std::max(a.right, b.right),
            std::max(a.top, b.top)};
}

/// Grown by a number of pixels on each side.
[[nodiscard]] inline PixelRectangle grown(const PixelRectangle& a, int by)
{
    return {a.left - by, a.bottom - by, a.right + by, a.top + by};
}

/// What lies in both.
[[nodiscard]] inline PixelRectangle common(const PixelRectangle& a, const PixelRectangle& b)
{
    return {std::max(a.left, b.left), std::max(a.bottom, b.bottom), std::min(a.right, b.right),
            std::min(a.top, b.top)};
}

/// Writes a row of premultiplied RGBA into a picture of three channels, or of four: then colours
/// are divided by alpha.
inline void writePixels(const std::uint8_t* from, int count, int channels, std::uint8_t* to)
{
    if (channels == 3)
    {
        // Four bytes at once; the next pixel overwrites the fourth, so the last takes three.
        for (int x = 0; x + 1 < count; ++x, from += 4, to += 3)
        {
            std::memcpy(to, from, 4);
        }
        std::memcpy(to, from, 3);
        return;
    }
    for (int x = 0; x < count; ++x, from += 4, to += 4)
    {
        const unsigned alpha = from[3];
        for (int c = 0; c < 3; ++c)
        {
            const unsigned straight = alpha == 0 ? 0 : (from[c] * 255U + alpha / 2) / alpha;
            to[c] = static_cast<std::uint8_t>(std::min(straight, 255U));
        }
        to[3] = from[3];
    }
}

} // namespace frostfill

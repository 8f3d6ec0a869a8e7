// SPDX-License-Identifier: MIT
#include "shown_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace frostfill
{
namespace
{

/// The parts of the picture that text may touch: the title as wide as it likes, and the table with
/// room for counts that grow. From the upper left corner.
std::array<PixelRectangle, 2> textParts(const Legend& legend, int width, int height)
{
    const int title = std::min(height, static_cast<int>(std::ceil(legend.titleHeight())) + 4);
    const int table = std::min(height, static_cast<int>(std::ceil(legend.height())) + 4);
    const int right = std::min(width, static_cast<int>(std::ceil(2.2 * legend.width())));
    return {PixelRectangle{0, height - title, width, height},
            PixelRectangle{0, height - table, right, height - title}};
}

} // namespace

void ShownPicture::copy(const PixelRectangle& part)
{
    const auto width = static_cast<std::size_t>(pixels_.width);
    const auto channels = static_cast<std::size_t>(pixels_.channels);
    const auto bytes = static_cast<std::size_t>(part.width()) * channels;
    for (int y = part.bottom; y < part.top; ++y)
    {
        const auto row = static_cast<std::size_t>(pixels_.height - 1 - y);
        const std::size_t at = (row * width + static_cast<std::size_t>(part.left)) * channels;
        std::memcpy(shown_.pixels.data() + at, pixels_.pixels.data() + at, bytes);
    }
}

void ShownPicture::finish(std::span<const PixelRectangle> parts, const Legend& legend,
                          const Snapshot& snapshot)
{
    changedRows_.assign(static_cast<std::size_t>(pixels_.height), 0);
    const auto mark = [&](const PixelRectangle& part)
    {
        const auto first = changedRows_.begin() + (pixels_.height - part.top);
        std::fill_n(first, part.height(), std::uint8_t{1});
    };
    hasText_ = legend.visible();
    for (const PixelRectangle& part : parts)
    {
        mark(part);
    }
    if (!hasText_)
    {
        return;
    }
    if (shown_.pixels.size() != pixels_.pixels.size())
    {
        shown_ = pixels_;
    }
    for (const PixelRectangle& part : parts)
    {
        copy(part);
    }
    for (const PixelRectangle& part : textParts(legend, pixels_.width, pixels_.height))
    {
        mark(part);
        copy(part);
    }
    legend.drawText(shown_, snapshot);
}

} // namespace frostfill

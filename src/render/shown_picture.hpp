// SPDX-License-Identifier: MIT
#pragma once

#include "legend.hpp"
#include "pixel_rectangle.hpp"

#include <frostfill/image.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The picture in memory, with text over it. The pixels without text are kept beside it, so that
/// text can change where nothing else does.
class ShownPicture
{
public:
    /// The pixels without text, to be brought up to date before finish().
    [[nodiscard]] Image& pixels() { return pixels_; }

    /// `parts` are those that have been brought up to date.
    void finish(std::span<const PixelRectangle> parts, const Legend& legend,
                const Snapshot& snapshot);

    [[nodiscard]] const Image& image() const { return hasText_ ? shown_ : pixels_; }
    /// [height] not 0 for rows that may have changed in the last finish().
    [[nodiscard]] std::span<const std::uint8_t> changedRows() const { return changedRows_; }

private:
    void copy(const PixelRectangle& part);

    bool hasText_ = false;
    Image pixels_;
    Image shown_;
    std::vector<std::uint8_t> changedRows_;
};

} // namespace frostfill

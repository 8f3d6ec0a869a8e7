// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/pixel_rectangle.hpp"
#include "render/overlay/legend.hpp"

#include <frostfill/image.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// The picture in memory, with text over it. The pixels without text are kept beside it, so that
/// text can change where nothing else does. Only what reads differently, or has something new
/// behind it, is written again.
class AnnotatedPicture
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
    /// A piece of the legend that is in the picture.
    struct Written
    {
        Legend::Piece piece;
        PixelRectangle bounds;
        bool lost = false; ///< has to be drawn again
    };

    void copy(const PixelRectangle& part);
    void mark(const PixelRectangle& part);
    void write(const Legend& legend, const Snapshot& snapshot);

    bool hasText_ = false;
    Image pixels_;
    Image shown_;
    std::vector<std::uint8_t> changedRows_;
    std::vector<Written> written_;
    std::vector<PixelRectangle> bare_; ///< parts of what is shown that lack their text
};

/// A picture `factor` times as small in both directions: each pixel is the mean of a square, with
/// colours counted by their alpha. What is left over at the right and bottom is dropped.
[[nodiscard]] Image shrunk(const Image& image, int factor);

} // namespace frostfill

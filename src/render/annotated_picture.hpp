// SPDX-License-Identifier: MIT
#pragma once

#include "render/framing/pixel_rectangle.hpp"
#include "render/overlay/legend.hpp"
#include "render/raster/swatch_raster.hpp"

#include <frostfill/image.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// The picture in memory, with the legend over it. The pixels without it are kept beside it, so
/// that text can change where nothing else does. It writes again only what reads differently, or
/// has something new behind it. A supersampled picture is written and made small as a whole.
class AnnotatedPicture
{
public:
    /// `viewpoint` must stay.
    explicit AnnotatedPicture(const Viewpoint& viewpoint);

    /// The pixels without the legend, to be brought up to date before finish().
    [[nodiscard]] Image& pixels() { return pixels_; }

    /// `parts` are those that have been brought up to date.
    void finish(std::span<const PixelRectangle> parts, const Snapshot& snapshot);

    [[nodiscard]] const Image& image() const { return isPlain_ ? pixels_ : shown_; }
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
    /// Returns what the legend shows, swatches first: text may lie over their background.
    [[nodiscard]] std::vector<Legend::Piece> pieces(const Snapshot& snapshot) const;
    [[nodiscard]] PixelRectangle bounds(const Legend::Piece& piece) const;
    void draw(const Legend::Piece& piece, Image& image);
    void write(const Snapshot& snapshot);
    void shrink(const Snapshot& snapshot);

    const Legend& legend_;
    std::optional<SwatchRaster> swatches_;
    int supersample_;
    bool isPlain_; ///< nothing is written into it, and it stays as large as it is
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

// SPDX-License-Identifier: MIT
#include "render/overlay/annotated_picture.hpp"

#include <algorithm>
#include <cstring>

namespace frostfill
{
void AnnotatedPicture::copy(const PixelRectangle& part)
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

void AnnotatedPicture::mark(const PixelRectangle& part)
{
    const auto first = changedRows_.begin() + (pixels_.height - part.top);
    std::fill_n(first, part.height(), std::uint8_t{1});
}

void AnnotatedPicture::finish(std::span<const PixelRectangle> parts, const Legend& legend,
                              const Snapshot& snapshot)
{
    changedRows_.assign(static_cast<std::size_t>(pixels_.height), 0);
    for (const PixelRectangle& part : parts)
    {
        mark(part);
    }
    hasText_ = legend.visible();
    if (!hasText_)
    {
        return;
    }
    if (shown_.pixels.size() != pixels_.pixels.size())
    {
        shown_ = pixels_;
        written_.clear();
    }
    bare_.assign(parts.begin(), parts.end());
    write(legend, snapshot);
}

void AnnotatedPicture::write(const Legend& legend, const Snapshot& snapshot)
{
    const std::vector<Legend::Piece> pieces = legend.pieces(snapshot);
    written_.resize(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        Written& written = written_[i];
        written.lost = false;
        if (written.piece != pieces[i])
        {
            bare_.push_back(written.bounds);
            written.piece = pieces[i];
            written.bounds = legend.bounds(pieces[i]);
            bare_.push_back(written.bounds);
        }
    }
    // Text is taken away by whole pieces, with all that overlap them.
    for (std::size_t i = 0; i < bare_.size(); ++i)
    {
        const PixelRectangle part = bare_[i];
        if (part.empty())
        {
            continue;
        }
        copy(part);
        mark(part);
        for (Written& written : written_)
        {
            if (!written.lost && written.bounds.overlaps(part))
            {
                written.lost = true;
                bare_.push_back(written.bounds);
            }
        }
    }
    for (const Written& written : written_)
    {
        if (written.lost)
        {
            legend.draw(shown_, written.piece);
        }
    }
}

Image shrunk(const Image& image, int factor)
{
    Image small;
    small.width = std::max(1, image.width / factor);
    small.height = std::max(1, image.height / factor);
    small.channels = image.channels;
    small.pixels.resize(static_cast<std::size_t>(small.width) *
                        static_cast<std::size_t>(small.height) *
                        static_cast<std::size_t>(small.channels));
    std::uint8_t* to = small.pixels.data();
    for (int y = 0; y < small.height; ++y)
    {
        for (int x = 0; x < small.width; ++x, to += small.channels)
        {
            std::array<unsigned, 3> sum{};
            unsigned weight = 0;
            for (int v = y * factor; v < (y + 1) * factor && v < image.height; ++v)
            {
                for (int u = x * factor; u < (x + 1) * factor && u < image.width; ++u)
                {
                    const std::uint8_t* from = image.at(u, v);
                    const unsigned alpha = image.channels == 4 ? from[3] : 255;
                    weight += alpha;
                    for (std::size_t c = 0; c < 3; ++c)
                    {
                        sum[c] += alpha * from[c];
                    }
                }
            }
            for (std::size_t c = 0; c < 3; ++c)
            {
                to[c] = static_cast<std::uint8_t>(weight == 0 ? 0 : (sum[c] + weight / 2) / weight);
            }
            if (image.channels == 4)
            {
                const auto pixels = static_cast<unsigned>(factor * factor);
                to[3] = static_cast<std::uint8_t>((weight + pixels / 2) / pixels);
            }
        }
    }
    return small;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "render/annotated_picture.hpp"

#include <algorithm>
#include <cstring>

namespace frostfill
{

AnnotatedPicture::AnnotatedPicture(const Viewpoint& viewpoint)
    : legend_(viewpoint.legend()), supersample_(viewpoint.settings().supersample),
      isPlain_(supersample_ == 1 && !legend_.visible())
{
    if (!legend_.spheres().empty())
    {
        swatches_.emplace(viewpoint);
    }
}

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

void AnnotatedPicture::finish(std::span<const PixelRectangle> parts, const Snapshot& snapshot)
{
    if (supersample_ > 1)
    {
        shrink(snapshot);
        return;
    }
    changedRows_.assign(static_cast<std::size_t>(pixels_.height), 0);
    for (const PixelRectangle& part : parts)
    {
        mark(part);
    }
    if (isPlain_)
    {
        return;
    }
    if (shown_.pixels.size() != pixels_.pixels.size())
    {
        shown_ = pixels_;
        written_.clear();
    }
    bare_.assign(parts.begin(), parts.end());
    write(snapshot);
}

void AnnotatedPicture::shrink(const Snapshot& snapshot)
{
    // Written into the pixels, which get back what lay there: a copy of all takes much memory.
    const std::vector<Legend::Piece> all = pieces(snapshot);
    PixelRectangle written;
    for (const Legend::Piece& piece : all)
    {
        written = around(written, bounds(piece));
    }
    const auto bytes = static_cast<std::size_t>(written.width()) * pixels_.channels;
    const auto row = [&](int y)
    { return pixels_.pixels.data() + (pixels_.at(written.left, y) - pixels_.at(0, 0)); };
    std::vector<std::uint8_t> before;
    for (int y = pixels_.height - written.top; y < pixels_.height - written.bottom; ++y)
    {
        before.insert(before.end(), row(y), row(y) + bytes);
    }
    for (const Legend::Piece& piece : all)
    {
        draw(piece, pixels_);
    }
    shown_ = shrunk(pixels_, supersample_);
    changedRows_.assign(static_cast<std::size_t>(shown_.height), 1);
    const std::uint8_t* from = before.data();
    for (int y = pixels_.height - written.top; y < pixels_.height - written.bottom; ++y)
    {
        std::memcpy(row(y), from, bytes);
        from += bytes;
    }
}

std::vector<Legend::Piece> AnnotatedPicture::pieces(const Snapshot& snapshot) const
{
    std::vector<Legend::Piece> pieces = legend_.pieces(snapshot);
    if (swatches_)
    {
        pieces.insert(pieces.begin(), {Legend::Piece::Kind::swatches, 0, 0, {}});
    }
    return pieces;
}

PixelRectangle AnnotatedPicture::bounds(const Legend::Piece& piece) const
{
    return piece.kind == Legend::Piece::Kind::swatches ? swatches_->pixels()
                                                       : legend_.bounds(piece);
}

void AnnotatedPicture::draw(const Legend::Piece& piece, Image& image)
{
    piece.kind == Legend::Piece::Kind::swatches ? swatches_->draw(image)
                                                : legend_.draw(image, piece);
}

void AnnotatedPicture::write(const Snapshot& snapshot)
{
    const std::vector<Legend::Piece> all = pieces(snapshot);
    written_.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        Written& written = written_[i];
        written.lost = false;
        if (written.bounds.empty() || written.piece != all[i])
        {
            bare_.push_back(written.bounds);
            written.piece = all[i];
            written.bounds = bounds(all[i]);
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
            draw(written.piece, shown_);
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

// SPDX-License-Identifier: MIT
#include "run/frame_writer.hpp"

#include "image/png_facts.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

FrameWriter::FrameWriter(const std::filesystem::path& directory, PngText text)
    : directory_(directory), text_(text), sequence_(directory, std::move(text))
{
}

bool FrameWriter::has(std::size_t frame, PictureSize size, const PngText& text) const
{
    constexpr std::size_t kPackedAtMost = 64; // [1] of what has any content
    const auto facts = pngFacts(directory_ / PngSequence::fileName(frame));
    PngText all = text_;
    all.insert(all.end(), text.begin(), text.end());
    const std::size_t bytes =
        3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return facts && facts->width == size.width && facts->height == size.height &&
           facts->text == all && facts->packedBytes * kPackedAtMost > bytes;
}

void FrameWriter::put(std::size_t frame, const Image& image,
                      std::span<const std::uint8_t> changedRows, std::size_t set, PngText text)
{
    // With one job at most waiting and one being done, the third copy is free.
    Copy& copy = copies_[next_];
    next_ = (next_ + 1) % copies_.size();
    copy.image = {image.width, image.height, image.channels, std::move(copy.image.pixels)};
    copy.image.pixels.resize(image.pixels.size());
    const std::size_t row =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    for (Copy& each : copies_)
    {
        each.staleRows.resize(changedRows.size(), 1);
    }
    for (std::size_t y = 0; y < changedRows.size(); ++y)
    {
        for (Copy& each : copies_)
        {
            each.staleRows[y] |= changedRows[y];
        }
        if (std::exchange(copy.staleRows[y], std::uint8_t{0}) != 0)
        {
            std::copy_n(image.pixels.data() + y * row, row, copy.image.pixels.data() + y * row);
        }
    }
    worker_.push([this, frame, &copy, set, text = std::move(text),
                  rows = std::vector<std::uint8_t>(changedRows.begin(), changedRows.end())]
                 { write(frame, copy.image, rows, set, text); });
}

void FrameWriter::write(std::size_t frame, const Image& image,
                        const std::vector<std::uint8_t>& changedRows, std::size_t set,
                        const PngText& text)
{
    const auto spent = [&]
    { return sequence_.times()[Stage::encoding] + sequence_.times()[Stage::writing]; };
    const double before = spent();
    sequence_.put(frame, image, changedRows, text);
    if (milliseconds_.size() <= set)
    {
        milliseconds_.resize(set + 1);
    }
    milliseconds_[set].push_back(1000 * (spent() - before));
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "run/frame_writer.hpp"

#include "image/png_facts.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{

FrameWriter::FrameWriter(const std::filesystem::path& directory, std::size_t limit, PngText text)
    : directory_(directory), text_(text), sequence_(directory, limit, std::move(text))
{
}

bool FrameWriter::has(std::size_t index, PictureSize size, const PngText& text) const
{
    constexpr std::size_t kPackedAtMost = 64; // [1] of what has any content
    const auto facts = pngFacts(directory_ / PngSequence::fileName(index));
    PngText all = text_;
    all.insert(all.end(), text.begin(), text.end());
    const std::size_t bytes =
        3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    return facts && facts->width == size.width && facts->height == size.height &&
           facts->text == all && facts->packedBytes * kPackedAtMost > bytes;
}

void FrameWriter::put(std::size_t number, const Image& image,
                      std::span<const std::uint8_t> changedRows, std::size_t set, PngText text)
{
    // With one job at most waiting and one being done, the third parcel is free.
    Parcel& parcel = parcels_[next_];
    next_ = (next_ + 1) % parcels_.size();
    parcel.number = number;
    parcel.set = set;
    parcel.width = image.width;
    parcel.height = image.height;
    parcel.channels = image.channels;
    parcel.text = std::move(text);
    parcel.changedRows.assign(changedRows.begin(), changedRows.end());
    parcel.pixels.clear();
    const std::size_t row =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    for (std::size_t y = 0; y < changedRows.size(); ++y)
    {
        if (changedRows[y] != 0)
        {
            const auto from = image.pixels.begin() + static_cast<std::ptrdiff_t>(y * row);
            parcel.pixels.insert(parcel.pixels.end(), from,
                                 from + static_cast<std::ptrdiff_t>(row));
        }
    }
    worker_.push([this, &parcel] { write(parcel); });
}

void FrameWriter::write(const Parcel& parcel)
{
    const std::size_t row =
        static_cast<std::size_t>(parcel.width) * static_cast<std::size_t>(parcel.channels);
    image_.width = parcel.width;
    image_.height = parcel.height;
    image_.channels = parcel.channels;
    image_.pixels.resize(row * static_cast<std::size_t>(parcel.height));
    auto from = parcel.pixels.begin();
    for (std::size_t y = 0; y < parcel.changedRows.size(); ++y)
    {
        if (parcel.changedRows[y] != 0)
        {
            std::copy_n(from, row, image_.pixels.begin() + static_cast<std::ptrdiff_t>(y * row));
            from += static_cast<std::ptrdiff_t>(row);
        }
    }

    const auto spent = [&]
    { return sequence_.times()[Stage::encoding] + sequence_.times()[Stage::writing]; };
    const double before = spent();
    sequence_.put(parcel.number, image_, parcel.changedRows, parcel.text);
    if (milliseconds_.size() <= parcel.set)
    {
        milliseconds_.resize(parcel.set + 1);
    }
    milliseconds_[parcel.set].push_back(1000 * (spent() - before));
}

void FrameWriter::skip(std::size_t number)
{
    worker_.push([this, number] { sequence_.skip(number); });
}

void FrameWriter::keepEvery(std::size_t stride)
{
    worker_.push([this, stride] { sequence_.keepEvery(stride); });
}

void FrameWriter::finish()
{
    worker_.finish();
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "png_grey16.hpp"

#include "deflate.hpp"

#include <frostfill/error.hpp>

#include <libdeflate.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace frostfill
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

void appendNumber(Bytes& bytes, std::uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8)
    {
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
}

/// [PNG 3rd edition, 5.3]: length, type, data, checksum of the latter two.
void appendChunk(Bytes& png, std::string_view type, const Bytes& data)
{
    appendNumber(png, static_cast<std::uint32_t>(data.size()));
    const std::size_t start = png.size();
    png.insert(png.end(), type.begin(), type.end());
    png.insert(png.end(), data.begin(), data.end());
    appendNumber(png, libdeflate_crc32(0, png.data() + start, png.size() - start));
}

} // namespace

std::vector<std::uint8_t> encodeGrey16(const Image& image)
{
    const auto stride = static_cast<std::size_t>(image.width) * 2;
    Bytes rows; // each with its filter in front: "up"
    rows.reserve((stride + 1) * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y)
    {
        const std::uint8_t* row = image.at(0, y);
        rows.push_back(2);
        for (std::size_t i = 0; i < stride; ++i)
        {
            const int above = y > 0 ? *(row + i - stride) : 0;
            rows.push_back(static_cast<std::uint8_t>(row[i] - above));
        }
    }
    int count = 0;
    const std::unique_ptr<unsigned char, decltype(&std::free)> packed(
        deflateForStb(rows.data(), static_cast<int>(rows.size()), &count, 0), &std::free);
    if (packed == nullptr)
    {
        throw Error(ErrorCode::outOfMemory, "no memory to encode a picture");
    }

    Bytes png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    Bytes header;
    appendNumber(header, static_cast<std::uint32_t>(image.width));
    appendNumber(header, static_cast<std::uint32_t>(image.height));
    constexpr std::array<std::uint8_t, 5> kGrey16 = {16, 0, 0, 0, 0}; // bits, grey, the only methods
    header.insert(header.end(), kGrey16.begin(), kGrey16.end());
    appendChunk(png, "IHDR", header);
    appendChunk(png, "IDAT", Bytes(packed.get(), packed.get() + count));
    appendChunk(png, "IEND", {});
    return png;
}

} // namespace frostfill

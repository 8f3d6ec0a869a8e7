// SPDX-License-Identifier: MIT
#include "image/png_bands.hpp"

#include "base/atomic_file.hpp"

#include <frostfill/error.hpp>

#include <isa-l/igzip_lib.h>
#include <libdeflate.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string_view>

namespace frostfill
{
namespace
{

/// Rows in a band. Smaller bands are reused more often but compress worse.
constexpr std::size_t kBandRows = 16;

constexpr std::uint8_t kFilterUp = 2;

/// The level of ISA-L. Level 1 writes 11 % fewer bytes, but version 2.30 has a fault in it: it
/// enters the third place of the data under a hash of the stream's address, so that equal data may
/// give other bytes (igzip_icf_body_h1_gr_bt.asm).
constexpr std::uint32_t kLevel = 0;

/// The length and type of a chunk precede its data; the checksum follows.
constexpr std::size_t kChunkHead = 8;
constexpr std::size_t kChunkTail = 4;

void putBigEndian(std::uint8_t* to, std::uint32_t value)
{
    for (int i = 0; i < 4; ++i)
    {
        to[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
    }
}

void beginChunk(std::vector<std::uint8_t>& bytes, std::string_view type)
{
    bytes.resize(bytes.size() + 4);
    bytes.insert(bytes.end(), type.begin(), type.end());
}

/// Completes the chunk from `start` to the end of the bytes: sets its length and appends the
/// checksum.
void endChunk(std::vector<std::uint8_t>& bytes, std::size_t start)
{
    const std::size_t size = bytes.size() - start - kChunkHead;
    putBigEndian(bytes.data() + start, static_cast<std::uint32_t>(size));
    const std::uint32_t sum = libdeflate_crc32(0, bytes.data() + start + 4, size + 4);
    bytes.resize(bytes.size() + kChunkTail);
    putBigEndian(bytes.data() + bytes.size() - kChunkTail, sum);
}

/// Adler-32 of two concatenated pieces of data, from the checksums of the pieces: sums of bytes,
/// and sums of those sums, modulo 65521 [RFC 1950, 8.2].
std::uint32_t joinAdler(std::uint32_t first, std::uint32_t second, std::size_t secondSize)
{
    constexpr std::uint64_t kBase = 65521;
    const std::uint64_t size = secondSize % kBase;
    const std::uint64_t low1 = first & 0xffffU;
    const std::uint64_t low2 = second & 0xffffU;
    const std::uint64_t low = (low1 + low2 + kBase - 1) % kBase;
    const std::uint64_t high =
        ((first >> 16) + (second >> 16) + size * low1 + (kBase - 1) * size) % kBase;
    return static_cast<std::uint32_t>(high << 16 | low);
}

/// Rows first..end-1 minus the row above, each preceded by the number of its filter.
void filterUp(const Image& image, std::size_t first, std::size_t end,
              std::vector<std::uint8_t>& filtered)
{
    const auto row =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    filtered.resize((end - first) * (row + 1));
    std::uint8_t* to = filtered.data();
    for (std::size_t y = first; y < end; ++y, to += row)
    {
        const std::uint8_t* from = image.pixels.data() + y * row;
        *to++ = kFilterUp;
        if (y == 0)
        {
            std::copy_n(from, row, to);
            continue;
        }
        const std::uint8_t* above = from - row;
        for (std::size_t i = 0; i < row; ++i)
        {
            to[i] = static_cast<std::uint8_t>(from[i] - above[i]);
        }
    }
}

/// Appends a text chunk. [PNG 3rd edition, 11.3.3.2]
void addText(std::string_view keyword, std::string_view text, std::vector<std::uint8_t>& file)
{
    assert(!keyword.empty() && keyword.size() < 80);
    const std::size_t start = file.size();
    beginChunk(file, "tEXt");
    file.insert(file.end(), keyword.begin(), keyword.end());
    file.push_back(0);
    file.insert(file.end(), text.begin(), text.end());
    endChunk(file, start);
}

void addHeader(const Image& image, std::vector<std::uint8_t>& file)
{
    constexpr std::array<std::uint8_t, 8> kSignature = {137, 'P', 'N', 'G', 13, 10, 26, 10};
    file.assign(kSignature.begin(), kSignature.end());
    const std::size_t start = file.size();
    beginChunk(file, "IHDR");
    file.resize(file.size() + 8);
    putBigEndian(file.data() + file.size() - 8, static_cast<std::uint32_t>(image.width));
    putBigEndian(file.data() + file.size() - 4, static_cast<std::uint32_t>(image.height));
    // 8 bits; RGB or RGBA; the only compression, the only set of filters, no interlacing.
    const std::uint8_t bits = image.channels == 2 ? 16 : 8;
    const std::uint8_t colours = image.channels == 2 ? 0 : image.channels == 4 ? 6 : 2;
    file.insert(file.end(), {bits, colours, 0, 0, 0});
    endChunk(file, start);
}

} // namespace

void deflateBand(const std::vector<std::uint8_t>& data, std::vector<std::uint8_t>& out)
{
    thread_local isal_zstream stream;
    const std::size_t start = out.size();
    // Incompressible data is stored, with five extra bytes for each block of 64 kB.
    out.resize(start + data.size() + data.size() / 1000 + 1024);
    isal_deflate_stateless_init(&stream);
    stream.hist_bits = 0; // the longest distances; not among what is set to begin with
    stream.level = kLevel;
    stream.flush = FULL_FLUSH;
    stream.end_of_stream = 0;
    stream.next_in = const_cast<std::uint8_t*>(data.data()); // which is only read
    stream.avail_in = static_cast<std::uint32_t>(data.size());
    stream.next_out = out.data() + start;
    stream.avail_out = static_cast<std::uint32_t>(out.size() - start);
    if (isal_deflate_stateless(&stream) != COMP_OK || stream.avail_in != 0)
    {
        throw Error(ErrorCode::outOfMemory, "a picture cannot be compressed");
    }
    out.resize(out.size() - stream.avail_out);
}

void PngBands::compress(const Image& image, std::size_t index, Band& band)
{
    thread_local std::vector<std::uint8_t> filtered;
    const std::size_t first = index * kBandRows;
    const std::size_t end = std::min(first + kBandRows, static_cast<std::size_t>(image.height));
    filterUp(image, first, end, filtered);
    band.size = filtered.size();
    band.adler = libdeflate_adler32(1, filtered.data(), filtered.size());
    band.chunk.clear();
    beginChunk(band.chunk, "IDAT");
    if (index == 0)
    {
        // The zlib stream's own header: deflate with a window of 32 kB, fastest. [RFC 1950, 2.2]
        band.chunk.insert(band.chunk.end(), {0x78, 0x01});
    }
    deflateBand(filtered, band.chunk);
    endChunk(band.chunk, 0);
}

const std::vector<std::uint8_t>& PngBands::encode(const Image& image, const PngText& text,
                                                  std::span<const std::uint8_t> changedRows)
{
    assert(image.channels >= 2 && image.channels <= 4);
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t count = (height + kBandRows - 1) / kBandRows;
    const bool sameShape =
        image.width == width_ && image.height == height_ && image.channels == channels_;
    const bool keep = sameShape && changedRows.size() == height;
    width_ = image.width;
    height_ = image.height;
    channels_ = image.channels;
    bands_.resize(count);
    wanted_.clear();
    for (std::size_t i = 0; i < count; ++i)
    {
        // The first row of a band depends on the row above it, which belongs to another band.
        const std::size_t first = i == 0 ? 0 : i * kBandRows - 1;
        const std::size_t end = std::min((i + 1) * kBandRows, height);
        if (!keep || std::any_of(changedRows.begin() + static_cast<std::ptrdiff_t>(first),
                                 changedRows.begin() + static_cast<std::ptrdiff_t>(end),
                                 [](std::uint8_t changed) { return changed != 0; }))
        {
            wanted_.push_back(i);
        }
    }
    tbb::parallel_for(std::size_t{0}, wanted_.size(),
                      [&](std::size_t i) { compress(image, wanted_[i], bands_[wanted_[i]]); });

    addHeader(image, file_);
    for (const auto& [keyword, value] : text)
    {
        addText(keyword, value, file_);
    }
    std::uint32_t adler = 1;
    for (const Band& band : bands_)
    {
        file_.insert(file_.end(), band.chunk.begin(), band.chunk.end());
        adler = joinAdler(adler, band.adler, band.size);
    }
    // An empty last block ends the stream. [RFC 1951, 3.2.6]
    const std::size_t start = file_.size();
    beginChunk(file_, "IDAT");
    file_.insert(file_.end(), {0x03, 0x00, 0, 0, 0, 0});
    putBigEndian(file_.data() + file_.size() - 4, adler);
    endChunk(file_, start);
    const std::size_t last = file_.size();
    beginChunk(file_, "IEND");
    endChunk(file_, last);
    return file_;
}

std::vector<std::uint8_t> encodePng(const Image& image, const PngText& text)
{
    return PngBands().encode(image, text);
}

void savePng(const Image& image, const std::filesystem::path& file, const PngText& text)
{
    saveBytes(encodePng(image, text), file);
}

namespace
{

constexpr std::string_view kSignature = "\x89PNG\r\n\x1A\n";
constexpr std::size_t kAroundChunk = 12; ///< bytes of its length, its name and its sum

std::uint32_t bigEndian(std::string_view bytes)
{
    std::uint32_t value = 0;
    for (const char byte : bytes.substr(0, 4))
    {
        value = value << 8 | static_cast<std::uint8_t>(byte);
    }
    return value;
}

/// Takes a chunk into the facts; false if it says what cannot be.
bool take(std::string_view name, std::string_view data, PngFacts& facts)
{
    if (name == "IHDR")
    {
        facts.width = static_cast<int>(bigEndian(data));
        facts.height = data.size() < 8 ? 0 : static_cast<int>(bigEndian(data.substr(4)));
        return data.size() == 13;
    }
    if (name == "tEXt")
    {
        const std::size_t end = data.find('\0');
        if (end == std::string_view::npos)
        {
            return false;
        }
        facts.text.emplace_back(data.substr(0, end), data.substr(end + 1));
    }
    facts.packedBytes += name == "IDAT" ? data.size() : 0;
    return true;
}

} // namespace

std::optional<PngFacts> pngFacts(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    std::string_view rest = bytes;
    if (!rest.starts_with(kSignature))
    {
        return std::nullopt;
    }
    rest.remove_prefix(kSignature.size());
    PngFacts facts;
    while (rest.size() >= kAroundChunk)
    {
        const std::size_t size = bigEndian(rest);
        if (size > rest.size() - kAroundChunk ||
            bigEndian(rest.substr(8 + size)) != libdeflate_crc32(0, rest.data() + 4, size + 4) ||
            !take(rest.substr(4, 4), rest.substr(8, size), facts))
        {
            return std::nullopt;
        }
        const bool ends = rest.substr(4, 4) == "IEND";
        rest.remove_prefix(kAroundChunk + size);
        if (ends)
        {
            return rest.empty() ? std::optional(facts) : std::nullopt;
        }
    }
    return std::nullopt;
}

} // namespace frostfill

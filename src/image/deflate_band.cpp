// SPDX-License-Identifier: MIT
#include "image/deflate_band.hpp"

#include <frostfill/error.hpp>

#include <isa-l/igzip_lib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <memory>

namespace frostfill
{
namespace
{

/// The level of ISA-L. Level 1 takes a third of the time of libdeflate's fastest level, for 4 %
/// more bytes.
constexpr std::uint32_t kLevel = 1;

/// Bits of the largest hash of that level.
constexpr int kHashBits = 13;

/// Streams at different addresses, see streamFor. The hash of one address must differ from three
/// others. Short data has short hashes, which addresses may share, so four streams are too few.
using Streams = std::array<isal_zstream, 16>;

/// The hash of ISA-L, of four bytes: the instruction crc32 (CRC-32C, reflected).
std::uint32_t hashOf(std::uint32_t bytes)
{
    for (int bit = 0; bit < 32; ++bit)
    {
        bytes = bytes >> 1 ^ (0x82f63b78U & (0U - (bytes & 1U)));
    }
    return bytes;
}

std::uint32_t fourBytes(const std::uint8_t* from)
{
    return std::uint32_t{from[0]} | std::uint32_t{from[1]} << 8 | std::uint32_t{from[2]} << 16 |
           std::uint32_t{from[3]} << 24;
}

/// ISA-L 2.30 has a fault: it enters the third place of the data into its table under a wrong hash,
/// that of bits 16 to 47 of the stream's address, because a register is not loaded
/// (igzip_icf_body_h1_gr_bt.asm). The output changes only where this hash equals that of one of the
/// first three places. So this chooses a stream whose address has another hash.
isal_zstream& streamFor(const std::vector<std::uint8_t>& data, Streams& streams)
{
    constexpr std::size_t kPlaces = 3;
    if (data.size() < kPlaces + 3)
    {
        return streams[0];
    }
    const int bits = std::min(static_cast<int>(std::bit_width(data.size())) - 1, kHashBits);
    const std::uint32_t mask = (1U << bits) - 1;
    std::array<std::uint32_t, kPlaces> hashes{};
    for (std::size_t i = 0; i < kPlaces; ++i)
    {
        hashes[i] = hashOf(fourBytes(data.data() + i)) & mask;
    }
    const auto found =
        std::find_if(streams.begin(), streams.end(),
                     [&](const isal_zstream& stream)
                     {
                         const auto address = reinterpret_cast<std::uintptr_t>(&stream);
                         const std::uint32_t wrong =
                             hashOf(static_cast<std::uint32_t>(address >> 16)) & mask;
                         return std::find(hashes.begin(), hashes.end(), wrong) == hashes.end();
                     });
    return found != streams.end() ? *found : streams[0];
}

} // namespace

void deflateBand(const std::vector<std::uint8_t>& data, std::vector<std::uint8_t>& out)
{
    thread_local const auto streams = std::make_unique_for_overwrite<Streams>(); // few are touched
    thread_local std::vector<std::uint8_t> work(ISAL_DEF_LVL1_DEFAULT);
    const std::size_t start = out.size();
    // Incompressible data is stored, with five extra bytes for each block of 64 kB.
    out.resize(start + data.size() + data.size() / 1000 + 1024);
    isal_zstream& stream = streamFor(data, *streams);
    isal_deflate_stateless_init(&stream);
    stream.hist_bits = 0; // the longest distances; not among what is set to begin with
    stream.level = kLevel;
    stream.level_buf = work.data();
    stream.level_buf_size = static_cast<std::uint32_t>(work.size());
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

} // namespace frostfill

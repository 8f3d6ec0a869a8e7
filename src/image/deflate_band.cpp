// SPDX-License-Identifier: MIT
#include "image/deflate_band.hpp"

#include <frostfill/error.hpp>

#include <isa-l/igzip_lib.h>

#include <cstddef>

namespace frostfill
{
namespace
{

/// The level of ISA-L. Level 1 writes 11 % fewer bytes, but version 2.30 has a fault in it: it
/// enters the third place of the data under a hash of the stream's address, so that equal data may
/// give other bytes (igzip_icf_body_h1_gr_bt.asm).
constexpr std::uint32_t kLevel = 0;

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

} // namespace frostfill

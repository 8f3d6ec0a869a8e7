// SPDX-License-Identifier: MIT
#include "image/deflate_band.hpp"

#include <frostfill/error.hpp>

#include <isa-l/igzip_lib.h>
#include <sys/mman.h>

#include <atomic>
#include <cstddef>
#include <memory>

namespace frostfill
{
namespace
{

/// The level of ISA-L. Level 1 takes a third of the time of libdeflate's fastest level, for 4 %
/// more bytes.
constexpr std::uint32_t kLevel = 1;

/// The hash of ISA-L, of four bytes: the instruction crc32 (CRC-32C, reflected).
std::uint32_t hashOf(std::uint32_t bytes)
{
    for (int bit = 0; bit < 32; ++bit)
    {
        bytes = bytes >> 1 ^ (0x82f63b78U & (0U - (bytes & 1U)));
    }
    return bytes;
}

/// The memory of one stream. ISA-L 2.30 has a fault: it enters the third place of the data into its
/// table under a wrong hash, that of bits 16 to 47 of the stream's address, because a register is
/// not loaded (igzip_icf_body_h1_gr_bt.asm). Where any place of the data has the same hash the
/// output may be another. So all streams lie at addresses that have one and the same hash.
class StreamMemory
{
public:
    StreamMemory()
    {
        for (int tries = 0; tries < kTries && place_ == MAP_FAILED; ++tries)
        {
            place_ = ::mmap(nextAddress(), kSize, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
        }
        if (place_ == MAP_FAILED)
        {
            // Somewhere: in one of some thousand cases bytes differ, pixels never.
            elsewhere_ = std::make_unique_for_overwrite<isal_zstream>();
        }
    }
    ~StreamMemory()
    {
        if (place_ != MAP_FAILED)
        {
            ::munmap(place_, kSize);
        }
    }
    StreamMemory(const StreamMemory&) = delete;
    StreamMemory& operator=(const StreamMemory&) = delete;

    isal_zstream& stream()
    {
        return elsewhere_ ? *elsewhere_ : *static_cast<isal_zstream*>(place_);
    }

private:
    static constexpr int kTries = 64;
    static constexpr std::size_t kSize = (sizeof(isal_zstream) + 4095) / 4096 * 4096;
    static constexpr std::uint32_t kHashMask = (1U << 13) - 1; ///< of the largest table
    static constexpr std::uint32_t kHash = 5461;               ///< of all; any number
    /// Where programs have nothing, in 64 kB.
    static constexpr std::uint32_t kFirst = 0x10000000;
    static constexpr std::uint32_t kEnd = 0x50000000;

    static void* nextAddress()
    {
        static std::atomic<std::uint32_t> next = kFirst;
        std::uint32_t upper = next;
        do
        {
            upper = next.fetch_add(1);
            if (upper >= kEnd)
            {
                next = kFirst;
            }
        } while ((hashOf(upper) & kHashMask) != kHash);
        const std::uintptr_t address = std::uintptr_t{upper} << 16;
        return reinterpret_cast<void*>(address); // NOLINT(performance-no-int-to-ptr)
    }

    void* place_ = MAP_FAILED;
    std::unique_ptr<isal_zstream> elsewhere_;
};

} // namespace

void deflateBand(const std::vector<std::uint8_t>& data, std::vector<std::uint8_t>& out)
{
    thread_local StreamMemory memory;
    thread_local std::vector<std::uint8_t> work(ISAL_DEF_LVL1_DEFAULT);
    const std::size_t start = out.size();
    // Incompressible data is stored, with five extra bytes for each block of 64 kB.
    out.resize(start + data.size() + data.size() / 1000 + 1024);
    isal_zstream& stream = memory.stream();
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

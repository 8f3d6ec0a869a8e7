// SPDX-License-Identifier: MIT
#include "mesh/files/readers.hpp"
#include "mesh/files/unreadable.hpp"

#define ZLIB_CONST // next_in points to bytes that stay
#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <new>

namespace frostfill
{
namespace
{

/// Larger: a small file takes the memory of a large one. Smaller: a mesh that repeats itself is
/// refused. [1]
constexpr std::size_t kMostGrowth = 256;
constexpr std::size_t kBelievedGrowth = 16; // what meshes as text come to, and twice that

/// A stream of zlib or of gzip that is unpacked.
class Inflater
{
public:
    static constexpr int kZlib = 15; // the base-2 logarithm of the largest window
    static constexpr int kGzip = 16 + kZlib;

    explicit Inflater(int format)
    {
        if (inflateInit2(&stream_, format) != Z_OK)
        {
            throw std::bad_alloc();
        }
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() { inflateEnd(&stream_); }

    /// Unpacks from the front of `packed`, behind the first `used` bytes of `to`. Returns zlib's
    /// code: Z_STREAM_END at the end.
    [[nodiscard]] int run(std::string_view& packed, std::string& to, std::size_t& used)
    {
        constexpr std::size_t kMost = std::size_t{1} << 30; // zlib counts with 32 bits
        const auto in = static_cast<uInt>(std::min(packed.size(), kMost));
        const auto out = static_cast<uInt>(std::min(to.size() - used, kMost));
        stream_.next_in = reinterpret_cast<const Bytef*>(packed.data());
        stream_.next_out = reinterpret_cast<Bytef*>(to.data()) + used;
        stream_.avail_in = in;
        stream_.avail_out = out;
        const int code = inflate(&stream_, Z_NO_FLUSH);
        packed.remove_prefix(in - stream_.avail_in);
        used += out - stream_.avail_out;
        return code;
    }

private:
    z_stream stream_{};
};

[[noreturn]] void refuseGrowth()
{
    throw Unreadable(fmt::format("it unpacks to more than {} times its size; unpack it first, if "
                                 "it is a mesh",
                                 kMostGrowth));
}

} // namespace

std::string gunzip(std::string_view packed)
{
    const std::size_t most = kMostGrowth * packed.size();
    std::string all(std::min(most, 4 * packed.size() + 1024), '\0');
    std::size_t used = 0;
    while (isGzip(packed))
    {
        Inflater tool(Inflater::kGzip);
        for (int code = Z_OK; code != Z_STREAM_END;)
        {
            if (used == all.size())
            {
                if (used == most)
                {
                    refuseGrowth();
                }
                all.resize(std::min(most, 2 * used));
            }
            code = tool.run(packed, all, used);
            if (code != Z_OK && code != Z_STREAM_END)
            {
                throw Unreadable("its compressed data (gzip) are cut off or damaged; compress the "
                                 "mesh again");
            }
        }
    }
    all.resize(used);
    return all;
}

void appendInflated(std::string_view packed, std::size_t size, std::string& to)
{
    if (size / kMostGrowth > packed.size())
    {
        refuseGrowth();
    }
    std::size_t used = to.size();
    to.resize(used + size);
    Inflater tool(Inflater::kZlib);
    int code = Z_OK;
    while (code == Z_OK)
    {
        code = tool.run(packed, to, used);
    }
    if (code != Z_STREAM_END || used != to.size())
    {
        throw Unreadable(
            "its compressed data (zlib) are cut off or damaged; export the mesh again");
    }
}

std::size_t contentSize(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    const std::streamoff told = stream ? static_cast<std::streamoff>(stream.tellg()) : 0;
    if (told <= 0)
    {
        return 0;
    }
    const auto size = static_cast<std::size_t>(told);
    std::array<char, 4> ends{}; // the first bytes, then the last ones
    if (!stream.seekg(0).read(ends.data(), 2) || !isGzip({ends.data(), 2}) ||
        !stream.seekg(-4, std::ios::end).read(ends.data(), ends.size()))
    {
        return size;
    }
    const std::size_t unpacked = loadNumber<std::uint32_t>(ends.data(), false);
    return std::clamp(unpacked, size, kBelievedGrowth * size);
}

} // namespace frostfill

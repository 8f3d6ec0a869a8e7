// SPDX-License-Identifier: MIT
// Writing PNG: stb_image_write makes the file, libdeflate does the work (six times as fast).
#include "deflate.hpp"
#include "png_grey16.hpp"

#include <frostfill/error.hpp>
#include <frostfill/image.hpp>

#include <fmt/core.h>
#include <libdeflate.h>
#include <stb_image_write.h>

#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <string_view>

namespace frostfill
{
namespace
{

/// Higher levels save 6 % of the bytes for twice the time.
constexpr int kDeflateLevel = 1;

/// PNG's filter "up": a pixel less the one above. A fixed filter needs no search, and pictures of
/// spheres on a plain ground gain nothing from the others.
constexpr int kFilterUp = 2;

/// Signature and header chunk, after which chunks of text may stand.
constexpr std::size_t kTextOffset = 8 + 4 + 4 + 13 + 4;

void appendBigEndian(std::vector<std::uint8_t>& bytes, std::uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8)
    {
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
}

/// [PNG 3rd edition, 11.3.3.2]: keyword, null, text.
std::vector<std::uint8_t> textChunk(std::string_view keyword, std::string_view text)
{
    assert(!keyword.empty() && keyword.size() < 80);
    std::string data = "tEXt";
    data.append(keyword).push_back('\0');
    data.append(text);

    std::vector<std::uint8_t> chunk;
    appendBigEndian(chunk, static_cast<std::uint32_t>(data.size() - 4));
    chunk.insert(chunk.end(), data.begin(), data.end());
    appendBigEndian(chunk, libdeflate_crc32(0, data.data(), data.size()));
    return chunk;
}

void append(void* context, void* data, int count)
{
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
    const auto* first = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), first, first + count);
}

/// Removes the file unless it has been renamed, so that nothing is left behind by a failure.
struct TemporaryFile
{
    std::filesystem::path path;
    ~TemporaryFile()
    {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
};

} // namespace

unsigned char* deflateForStb(unsigned char* bytes, int count, int* countOut, int /*quality*/)
{
    using Compressor =
        std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)>;
    thread_local const Compressor compressor(libdeflate_alloc_compressor(kDeflateLevel),
                                             &libdeflate_free_compressor);
    if (compressor == nullptr)
    {
        return nullptr;
    }
    const auto size = static_cast<std::size_t>(count);
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), size);
    auto* out = static_cast<unsigned char*>(std::malloc(bound));
    if (out == nullptr)
    {
        return nullptr;
    }
    *countOut =
        static_cast<int>(libdeflate_zlib_compress(compressor.get(), bytes, size, out, bound));
    return out;
}

unsigned int crc32ForStb(unsigned char* bytes, int count)
{
    return libdeflate_crc32(0, bytes, static_cast<std::size_t>(count));
}

namespace
{

std::vector<std::uint8_t> encodeWithStb(const Image& image)
{
    assert(image.channels == 3 || image.channels == 4);
    assert(image.pixels.size() == static_cast<std::size_t>(image.width) *
                                      static_cast<std::size_t>(image.height) *
                                      static_cast<std::size_t>(image.channels));
    // The filter is a global of stb: set once, so that encoders may run in several threads.
    static std::once_flag filterSet;
    std::call_once(filterSet, [] { stbi_write_force_png_filter = kFilterUp; });

    std::vector<std::uint8_t> png;
    if (stbi_write_png_to_func(&append, &png, image.width, image.height, image.channels,
                               image.pixels.data(), image.width * image.channels) == 0)
    {
        throw Error(ErrorCode::outOfMemory,
                    fmt::format("no memory to encode a picture of {}x{} pixels", image.width,
                                image.height));
    }
    return png;
}

} // namespace

std::vector<std::uint8_t> encodePng(const Image& image, const PngText& text)
{
    std::vector<std::uint8_t> png =
        image.channels == 2 ? encodeGrey16(image) : encodeWithStb(image);
    std::vector<std::uint8_t> chunks;
    for (const auto& [keyword, value] : text)
    {
        const auto chunk = textChunk(keyword, value);
        chunks.insert(chunks.end(), chunk.begin(), chunk.end());
    }
    png.insert(png.begin() + kTextOffset, chunks.begin(), chunks.end());
    return png;
}

void savePng(const Image& image, const std::filesystem::path& file, const PngText& text)
{
    const std::vector<std::uint8_t> png = encodePng(image, text);

    // The process number keeps two runs that write to one directory apart.
    TemporaryFile temporary{file};
    temporary.path += fmt::format(".{}.tmp", ::getpid());
    std::FILE* out = std::fopen(temporary.path.c_str(), "wb");
    if (out == nullptr)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file.string(), std::strerror(errno)));
    }
    const bool written = std::fwrite(png.data(), 1, png.size(), out) == png.size();
    const int writeError = errno;
    const bool closed = std::fclose(out) == 0;
    if (!written || !closed)
    {
        throw Error(ErrorCode::writeFailed,
                    fmt::format("cannot write {}: {}", file.string(),
                                std::strerror(written ? errno : writeError)));
    }
    std::error_code failure;
    std::filesystem::rename(temporary.path, file, failure);
    if (failure)
    {
        throw Error(ErrorCode::cannotCreate,
                    fmt::format("cannot create {}: {}", file.string(), failure.message()));
    }
}

} // namespace frostfill

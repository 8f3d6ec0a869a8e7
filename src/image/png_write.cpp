// SPDX-License-Identifier: MIT
// Writes PNG: stb_image_write builds the file, and libdeflate compresses it (six times faster).
#include "base/atomic_file.hpp"
#include "image/deflate.hpp"
#include "image/png_bands.hpp"

#include <frostfill/error.hpp>
#include <frostfill/image.hpp>

#include <fmt/core.h>
#include <libdeflate.h>
#include <stb_image_write.h>

#include <cassert>
#include <cstdlib>
#include <memory>
#include <mutex>

namespace frostfill
{
namespace
{

/// Higher levels save 6 % of the bytes and take twice the time.
constexpr int kDeflateLevel = 1;

/// The PNG filter "up": a pixel minus the pixel above. A fixed filter needs no search, and pictures
/// of spheres on a plain background gain nothing from the other filters.
constexpr int kStbFilterUp = 2;

/// Size of the signature and the header chunk. Text chunks may follow them.
constexpr std::size_t kTextOffset = 8 + 4 + 4 + 13 + 4;

void append(void* context, void* data, int count)
{
    auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
    const auto* first = static_cast<const std::uint8_t*>(data);
    bytes.insert(bytes.end(), first, first + count);
}

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

std::vector<std::uint8_t> encodePng(const Image& image, const PngText& text)
{
    if (image.channels == 2) // stb_image_write cannot write these
    {
        const std::vector<std::uint8_t> allRows(static_cast<std::size_t>(image.height), 1);
        return PngBands().encode(image, text, allRows);
    }
    assert(image.channels == 3 || image.channels == 4);
    assert(image.pixels.size() == static_cast<std::size_t>(image.width) *
                                      static_cast<std::size_t>(image.height) *
                                      static_cast<std::size_t>(image.channels));
    // The filter is a global variable of stb. It is set once, so encoders can run in several
    // threads.
    static std::once_flag filterSet;
    std::call_once(filterSet, [] { stbi_write_force_png_filter = kStbFilterUp; });

    std::vector<std::uint8_t> png;
    if (stbi_write_png_to_func(&append, &png, image.width, image.height, image.channels,
                               image.pixels.data(), image.width * image.channels) == 0)
    {
        throw Error(ErrorCode::outOfMemory,
                    fmt::format("no memory to encode a picture of {}x{} pixels", image.width,
                                image.height));
    }
    std::vector<std::uint8_t> chunks;
    for (const auto& [keyword, value] : text)
    {
        const auto chunk = pngTextChunk(keyword, value);
        chunks.insert(chunks.end(), chunk.begin(), chunk.end());
    }
    png.insert(png.begin() + kTextOffset, chunks.begin(), chunks.end());
    return png;
}

void savePng(const Image& image, const std::filesystem::path& file, const PngText& text)
{
    saveBytes(encodePng(image, text), file);
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "page/sections.hpp"

#include <libdeflate.h>

#include <cstddef>
#include <memory>
#include <new>

namespace frostfill
{
namespace
{

/// From 7 to 12 pages shrink by 2 % and take ten times as long.
constexpr int kLevel = 7;

std::string deflated(std::string_view bytes)
{
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
    if (!compressor)
    {
        throw std::bad_alloc();
    }
    std::string packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    packed.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(),
                                           packed.data(), packed.size()));
    return packed;
}

} // namespace

std::string base64(std::string_view bytes)
{
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        const auto byte = [&](std::size_t k) -> unsigned
        { return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0; };
        const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t digit = 0; digit < 4; ++digit)
        {
            const bool padding = i + digit > bytes.size();
            text += padding ? '=' : kDigits[three >> (18 - 6 * digit) & 63];
        }
    }
    return text;
}

std::string packedText(const Sections& sections)
{
    std::string all;
    for (const auto& [name, bytes] : sections)
    {
        all += bytes;
    }
    return base64(deflated(all));
}

} // namespace frostfill

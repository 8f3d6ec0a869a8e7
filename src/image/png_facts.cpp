// SPDX-License-Identifier: MIT
#include "image/png_facts.hpp"

#include <libdeflate.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <string_view>

namespace frostfill
{
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

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

enum class PlyFormat
{
    ascii,
    littleEndian,
    bigEndian
};

enum class PlyType : std::uint8_t
{
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};

[[nodiscard]] std::size_t sizeOf(PlyType type); ///< [byte]

struct PlyProperty
{
    std::string_view name;
    PlyType type = PlyType::int8;
    bool isList = false;
    PlyType countType = PlyType::uint8; ///< of a list
};

struct PlyElement
{
    std::string_view name;
    std::uint64_t count = 0;
    std::uint64_t line = 0; ///< where it is promised
    std::vector<PlyProperty> properties;
};

/// Names point into the text.
struct PlyHeader
{
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t bodyAt = 0;     ///< [byte] where the data begin
    std::uint64_t bodyLine = 0; ///< the line in which they begin
};

/// Throws Unreadable.
[[nodiscard]] PlyHeader readPlyHeader(std::string_view bytes);

} // namespace frostfill

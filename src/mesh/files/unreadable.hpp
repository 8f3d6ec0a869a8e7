// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace frostfill
{

/// Why a file is no mesh, without the file's name, which readMesh puts before it. Never leaves the
/// library.
class Unreadable : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Where in a file: a line of a text, or a byte.
struct Place
{
    std::string_view unit; ///< "line", counted from 1, or "byte", counted from 0
    std::uint64_t number = 0;
};

[[noreturn]] inline void refuseAt(const Place& place, std::string_view why)
{
    throw Unreadable(fmt::format("{} {}: {}", place.unit, place.number, why));
}

/// A count that no file of this size can keep. It is refused before memory is asked for.
[[noreturn]] inline void refuseCount(const Place& place, std::uint64_t count, std::string_view what,
                                     std::uint64_t bytesLeft)
{
    refuseAt(place, fmt::format("{} {} are promised, but only {} bytes follow; the file is cut off "
                                "or damaged: export the mesh again",
                                count, what, bytesLeft));
}

inline void refuseNotFinite(double coordinate, const Place& place)
{
    if (!std::isfinite(coordinate))
    {
        refuseAt(place, "a coordinate is infinite or not a number; export the mesh again");
    }
}

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie in memory");

/// A number from where it lies, in whatever order its bytes are.
template <typename Number>
[[nodiscard]] Number loadNumber(const char* from, bool bigEndian)
{
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(from, sizeof(Number), bytes.begin());
    if (bigEndian)
    {
        std::reverse(bytes.begin(), bytes.end());
    }
    return std::bit_cast<Number>(bytes);
}

/// A type of numbers in files of PLY and VTK.
struct NumberType
{
    std::array<std::string_view, 4> names; ///< of PLY, then of VTK; empty for none
    std::size_t size = 0;                  ///< [byte]
    bool isWhole = false;
    double (*load)(const char*, bool bigEndian) = nullptr; ///< indices are below 2^53
};

/// The type of that name; null for none.
[[nodiscard]] inline const NumberType* findNumberType(std::string_view name)
{
    constexpr auto typeOf = []<typename Number>(Number, std::array<std::string_view, 4> names)
    {
        return NumberType{names, sizeof(Number), !std::is_floating_point_v<Number>,
                          [](const char* from, bool bigEndian)
                          { return static_cast<double>(loadNumber<Number>(from, bigEndian)); }};
    };
    static constexpr std::array<NumberType, 11> kTypes = {{
        typeOf(float{}, {"float", "float32", "Float32", ""}),
        typeOf(double{}, {"double", "float64", "Float64", ""}),
        typeOf(std::int8_t{}, {"char", "int8", "Int8", ""}),
        typeOf(std::uint8_t{}, {"uchar", "uint8", "UInt8", "unsigned_char"}),
        typeOf(std::int16_t{}, {"short", "int16", "Int16", ""}),
        typeOf(std::uint16_t{}, {"ushort", "uint16", "UInt16", "unsigned_short"}),
        typeOf(std::int32_t{}, {"int", "int32", "Int32", "vtkIdType"}), // of 32 bits in files
        typeOf(std::uint32_t{}, {"uint", "uint32", "UInt32", "unsigned_int"}),
        typeOf(std::int64_t{}, {"long", "int64", "Int64", "vtktypeint64"}),
        typeOf(std::uint64_t{}, {"ulong", "uint64", "UInt64", "vtktypeuint64"}),
        typeOf(std::uint64_t{}, {"unsigned_long", "", "", ""}),
    }};
    const auto* const found =
        std::find_if(kTypes.begin(), kTypes.end(),
                     [&](const NumberType& type)
                     {
                         return !name.empty() && std::find(type.names.begin(), type.names.end(),
                                                           name) != type.names.end();
                     });
    return found == kTypes.end() ? nullptr : found;
}

} // namespace frostfill

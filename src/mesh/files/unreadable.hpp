// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

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

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// The first bytes of a run file: a name and the version of the format.
inline constexpr std::string_view kRunFileMagic{"frostrun\2\0\0\0", 12};
inline constexpr std::size_t kRunFileVersionAt = 8; ///< in the mark

enum class RecordKind : std::uint32_t
{
    head = 1,    ///< JSON
    mesh = 2,    ///< PLY
    frames = 3,  ///< some frames that follow each other
    summary = 4, ///< JSON; the last record
};

/// What stands before the bytes of a record. 24 bytes, little-endian.
struct RecordHeader
{
    RecordKind kind = RecordKind::head;
    std::uint32_t count = 0;  ///< of frames; their numbers follow first, 4 bytes each
    std::uint32_t bytes = 0;  ///< that follow: the numbers and what zstd has packed
    std::uint32_t raw = 0;    ///< bytes after unpacking
    std::uint32_t sum = 0;    ///< CRC-32 of the bytes that follow
    std::uint32_t ownSum = 0; ///< CRC-32 of the 20 bytes before
};
static_assert(sizeof(RecordHeader) == 24);

/// A record as it stands in the file. `frames` are the numbers of those in it.
[[nodiscard]] std::string packRecord(RecordKind kind, std::span<const std::uint32_t> frames,
                                     std::string_view bytes);

/// A whole record in a file's bytes.
struct Record
{
    RecordHeader header;
    std::string_view bytes; ///< that follow the header
};

/// The whole records of a file, up to the first that is torn or damaged.
[[nodiscard]] std::vector<Record> wholeRecords(std::string_view file);

[[nodiscard]] std::vector<std::uint32_t> frameNumbers(const Record& record);

/// Throws DamagedBytes.
[[nodiscard]] std::string unpackRecord(const Record& record);

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "run_file/records.hpp"

#include "run_file/bytes.hpp"

#include <libdeflate.h>
#include <zstd.h>

#include <algorithm>
#include <limits>

namespace frostfill
{
namespace
{

/// Higher levels make a run file a tenth smaller and take several times as long.
constexpr int kZstdLevel = 3;

std::uint32_t sumOf(std::string_view bytes)
{
    return libdeflate_crc32(0, bytes.data(), bytes.size());
}

std::uint32_t sumOf(const RecordHeader& header)
{
    return sumOf({reinterpret_cast<const char*>(&header), offsetof(RecordHeader, ownSum)});
}

bool isKnown(RecordKind kind)
{
    return kind >= RecordKind::head && kind <= RecordKind::summary;
}

} // namespace

std::string packRecord(RecordKind kind, std::span<const std::uint32_t> frames,
                       std::string_view bytes)
{
    const std::size_t start = sizeof(RecordHeader) + frames.size_bytes();
    std::string record(start + ZSTD_compressBound(bytes.size()), '\0');
    const std::size_t packed = ZSTD_compress(record.data() + start, record.size() - start,
                                             bytes.data(), bytes.size(), kZstdLevel);
    if (ZSTD_isError(packed) != 0 || bytes.size() > std::numeric_limits<std::uint32_t>::max())
    {
        throw std::length_error("a record of more than 4 GB");
    }
    record.resize(start + packed);
    if (!frames.empty()) // a null pointer is no place, not even of nothing
    {
        std::memcpy(record.data() + sizeof(RecordHeader), frames.data(), frames.size_bytes());
    }
    RecordHeader header;
    header.kind = kind;
    header.count = static_cast<std::uint32_t>(frames.size());
    header.bytes = static_cast<std::uint32_t>(record.size() - sizeof header);
    header.raw = static_cast<std::uint32_t>(bytes.size());
    header.sum = sumOf(std::string_view(record).substr(sizeof header));
    header.ownSum = sumOf(header);
    std::memcpy(record.data(), &header, sizeof header);
    return record;
}

std::vector<Record> wholeRecords(std::string_view file)
{
    std::vector<Record> records;
    file.remove_prefix(std::min(file.size(), kRunFileMagic.size()));
    while (file.size() >= sizeof(RecordHeader))
    {
        Record record;
        std::memcpy(&record.header, file.data(), sizeof record.header);
        file.remove_prefix(sizeof record.header);
        if (record.header.ownSum != sumOf(record.header) || !isKnown(record.header.kind) ||
            record.header.bytes > file.size() ||
            record.header.count > record.header.bytes / sizeof(std::uint32_t))
        {
            break;
        }
        record.bytes = file.substr(0, record.header.bytes);
        if (record.header.sum != sumOf(record.bytes))
        {
            break;
        }
        file.remove_prefix(record.header.bytes);
        records.push_back(record);
    }
    return records;
}

std::vector<std::uint32_t> frameNumbers(const Record& record)
{
    std::vector<std::uint32_t> numbers(record.header.count);
    if (!numbers.empty())
    {
        std::memcpy(numbers.data(), record.bytes.data(), numbers.size() * sizeof(std::uint32_t));
    }
    return numbers;
}

std::string unpackRecord(const Record& record)
{
    const std::string_view packed =
        record.bytes.substr(record.header.count * sizeof(std::uint32_t));
    // What zstd itself says is asked before memory is set aside.
    if (ZSTD_getFrameContentSize(packed.data(), packed.size()) != record.header.raw)
    {
        throw DamagedBytes("has a record of another size than it says");
    }
    std::string bytes(record.header.raw, '\0');
    const std::size_t size =
        ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    if (ZSTD_isError(size) != 0 || size != bytes.size())
    {
        throw DamagedBytes("has a record that cannot be unpacked");
    }
    return bytes;
}

} // namespace frostfill

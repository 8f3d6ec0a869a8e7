// SPDX-License-Identifier: MIT
#include "export/npz_file.hpp"

#include "output/npy_header.hpp"
#include "run_file/bytes.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <libdeflate.h>

namespace frostfill
{
namespace
{

// Fields of ZIP [APPNOTE 6.3.10]. Sizes follow the data, because they are not known before.
constexpr std::uint16_t kVersion = 20;
constexpr std::uint16_t kSizesFollow = 8;
constexpr std::uint16_t kNotCompressed = 0;
constexpr std::uint32_t kJanuary1980 = 33U << 16; // the same bytes at any time
constexpr std::uint64_t kMax = 0xFFFFFFFF;

} // namespace

void NpzFile::put(std::string_view bytes)
{
    file_.write(bytes);
    written_ += bytes.size();
}

void NpzFile::begin(const std::string& name, std::string_view type,
                    const std::vector<std::size_t>& shape)
{
    entries_.push_back({.name = name + ".npy", .at = written_});
    ByteWriter header;
    header.raw(std::uint32_t{0x04034B50});
    header.raw(kVersion);
    header.raw(kSizesFollow);
    header.raw(kNotCompressed);
    header.raw(kJanuary1980);
    for (int i = 0; i < 3; ++i)
    {
        header.raw(std::uint32_t{0}); // sum and sizes
    }
    header.raw(static_cast<std::uint16_t>(entries_.back().name.size()));
    header.raw(std::uint16_t{0});
    header.bytes() += entries_.back().name;
    put(header.bytes());

    write(npyHeader(type, shape));
}

void NpzFile::write(std::string_view bytes)
{
    Entry& entry = entries_.back();
    entry.sum = libdeflate_crc32(entry.sum, bytes.data(), bytes.size());
    entry.size += bytes.size();
    put(bytes);
}

void NpzFile::end()
{
    const Entry& entry = entries_.back();
    if (written_ > kMax)
    {
        throw Error(ErrorCode::badData,
                    "the arrays take more than 4 GiB, which an .npz file cannot "
                    "hold; choose fewer --frames");
    }
    ByteWriter sizes;
    sizes.raw(std::uint32_t{0x08074B50});
    sizes.raw(entry.sum);
    sizes.raw(static_cast<std::uint32_t>(entry.size));
    sizes.raw(static_cast<std::uint32_t>(entry.size));
    put(sizes.bytes());
}

void NpzFile::commit()
{
    const std::uint64_t start = written_;
    ByteWriter directory;
    for (const Entry& entry : entries_)
    {
        directory.raw(std::uint32_t{0x02014B50});
        directory.raw(kVersion);
        directory.raw(kVersion);
        directory.raw(kSizesFollow);
        directory.raw(kNotCompressed);
        directory.raw(kJanuary1980);
        directory.raw(entry.sum);
        directory.raw(static_cast<std::uint32_t>(entry.size));
        directory.raw(static_cast<std::uint32_t>(entry.size));
        directory.raw(static_cast<std::uint16_t>(entry.name.size()));
        directory.raw(std::uint64_t{0}); // extra, comment, disk, kind
        directory.raw(std::uint32_t{0}); // attributes
        directory.raw(static_cast<std::uint32_t>(entry.at));
        directory.bytes() += entry.name;
    }
    const auto size = static_cast<std::uint32_t>(directory.bytes().size());
    const auto count = static_cast<std::uint16_t>(entries_.size());
    directory.raw(std::uint32_t{0x06054B50});
    directory.raw(std::uint32_t{0});
    directory.raw(count);
    directory.raw(count);
    directory.raw(size);
    directory.raw(static_cast<std::uint32_t>(start));
    directory.raw(std::uint16_t{0});
    put(directory.bytes());
    file_.commit();
}

} // namespace frostfill

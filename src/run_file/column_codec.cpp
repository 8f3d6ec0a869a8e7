// SPDX-License-Identifier: MIT
#include "run_file/column_codec.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// Counts change by a little, so they are written as differences; both wrap around.
void putValue(ByteWriter& out, ColumnType type, std::uint32_t before, std::uint32_t now)
{
    if (type == ColumnType::uint32)
    {
        out.difference(static_cast<std::int32_t>(now - before));
    }
    else
    {
        out.raw(now);
    }
}

std::uint32_t getValue(ByteReader& in, ColumnType type, std::uint32_t before)
{
    return type == ColumnType::uint32 ? before + static_cast<std::uint32_t>(in.difference())
                                      : in.raw<std::uint32_t>();
}

} // namespace

void putColumns(const std::vector<ColumnValues>& columns, ByteWriter& out)
{
    out.count(columns.size());
    for (const ColumnValues& values : columns)
    {
        out.count(values.column().name.size());
        out.bytes() += values.column().name;
        out.raw(values.column().type);
    }
}

std::vector<FileColumn> getColumns(ByteReader& in)
{
    std::vector<FileColumn> columns(in.countOfMany());
    for (FileColumn& column : columns)
    {
        column.name.resize(in.countOfMany());
        for (char& letter : column.name)
        {
            letter = in.raw<char>();
        }
        column.type = in.raw<ColumnType>();
        if (column.type != ColumnType::uint32 && column.type != ColumnType::float32)
        {
            throw DamagedBytes("has a column of a type that there is not");
        }
        const Column* known = findColumn(column.name);
        if (known != nullptr && known->isCarried() && known->type == column.type)
        {
            column.known = known;
        }
    }
    return columns;
}

void ColumnEncoder::encode(const Snapshot& snapshot, std::span<const std::uint32_t> looked,
                           ByteWriter& out)
{
    for (ColumnValues& written : written_)
    {
        const ColumnValues* values = snapshot.values(written.column());
        const auto bitsOf = [&](std::uint32_t id)
        { return values != nullptr && id < values->bits.size() ? values->bits[id] : 0; };
        written.bits.resize(snapshot.states.size());
        std::vector<std::uint32_t> ids;
        for (const std::uint32_t id : looked)
        {
            if (written.bits[id] != bitsOf(id))
            {
                ids.push_back(id);
            }
        }
        out.ids(ids);
        for (const std::uint32_t id : ids)
        {
            const std::uint32_t before = std::exchange(written.bits[id], bitsOf(id));
            putValue(out, written.column().type, before, written.bits[id]);
        }
    }
}

std::vector<ColumnValues> ColumnDecoder::carried() const
{
    std::vector<ColumnValues> carried;
    for (const FileColumn& column : columns_)
    {
        if (column.known != nullptr)
        {
            carried.emplace_back(*column.known);
        }
    }
    return carried;
}

void ColumnDecoder::decode(ByteReader& in, Snapshot& snapshot) const
{
    auto values = snapshot.columns.begin();
    for (const FileColumn& column : columns_)
    {
        std::vector<std::uint32_t>* bits = column.known != nullptr ? &(values++)->bits : nullptr;
        const std::vector<std::uint32_t> ids = in.ids(snapshot.states.size());
        for (const std::uint32_t id : ids)
        {
            const std::uint32_t now = getValue(in, column.type, bits != nullptr ? (*bits)[id] : 0);
            if (bits != nullptr)
            {
                (*bits)[id] = now;
                snapshot.changed.push_back(id);
            }
        }
    }
}

} // namespace frostfill

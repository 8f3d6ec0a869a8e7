// SPDX-License-Identifier: MIT
#pragma once

#include "run_file/bytes.hpp"

#include <frostfill/snapshot.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// A carried column as a file names it.
struct FileColumn
{
    std::string name;
    ColumnType type = ColumnType::float32; ///< uint32 or float32
    const Column* known = nullptr;         ///< null: this program does not have it
};

/// How many columns there are, and of each its name and its type.
void putColumns(const std::vector<ColumnValues>& columns, ByteWriter& out);
/// Throws DamagedBytes.
[[nodiscard]] std::vector<FileColumn> getColumns(ByteReader& in);

/// Writes what has changed in the columns of a snapshot since the one before: of each column the
/// ids, and then the values. Looks only at the spheres that are named, in ascending order.
class ColumnEncoder
{
public:
    explicit ColumnEncoder(const std::vector<ColumnValues>& columns = {}) : written_(columns) {}
    void encode(const Snapshot& snapshot, std::span<const std::uint32_t> looked, ByteWriter& out);

private:
    std::vector<ColumnValues> written_;
};

/// Reads what ColumnEncoder wrote into a snapshot that has room for its spheres.
class ColumnDecoder
{
public:
    explicit ColumnDecoder(std::vector<FileColumn> columns = {}) : columns_(std::move(columns)) {}
    /// The columns that the snapshot is to have: those that are known.
    [[nodiscard]] std::vector<ColumnValues> carried() const;
    /// Appends to Snapshot::changed. Throws DamagedBytes.
    void decode(ByteReader& in, Snapshot& snapshot) const;

private:
    std::vector<FileColumn> columns_;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "base/atomic_file.hpp"
#include "export/exporter.hpp"
#include "output/column_text.hpp"
#include "run_file/bytes.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace frostfill
{

using ColumnList = std::vector<const Column*>;

/// A sphere in the world.
[[nodiscard]] inline SphereRow rowOf(const ExportedRun& run, const ExportedFrame& frame,
                                     std::size_t i)
{
    const Snapshot& state = frame.state;
    return {static_cast<std::uint32_t>(i),
            frame.centre(i),
            frame.radii[i],
            state.states[i],
            state.groups[i],
            state.groups[i] / run.groupsPerSet,
            state.speeds[i],
            state.columns};
}

/// What a run has of the columns that go to exports, in the order of the table.
[[nodiscard]] ColumnList exportedColumns(const Snapshot& state);
/// The same without some.
[[nodiscard]] ColumnList without(const ColumnList& columns, bool (*left)(const Column& column));

inline bool isId(const Column& column)
{
    return column.name == "id";
}
/// Coordinates of the centre, which some formats put elsewhere.
inline bool isCoordinate(const Column& column)
{
    return !column.frame.empty();
}

/// Appends the values of a sphere, each behind a separator.
inline void putText(fmt::memory_buffer& row, const SphereRow& sphere, const ColumnList& columns,
                    char separator)
{
    for (const Column* column : columns)
    {
        row.push_back(separator);
        putText(row, *column, sphere.value(*column));
    }
}

inline void putBytes(ByteWriter& out, const Column& column, double value)
{
    visitNumber(column, value, [&](auto number) { out.raw(number); });
}

/// The name of a type among those of a format, which are in the order of ColumnType.
[[nodiscard]] inline const char* typeName(const Column& column, const char* const (&names)[4])
{
    return names[static_cast<std::size_t>(column.type)];
}

[[nodiscard]] inline std::size_t bytesOf(const Column& column)
{
    constexpr std::size_t kBytes[] = {1, 4, 4, 8};
    return kBytes[static_cast<std::size_t>(column.type)];
}

/// Writes a line a sphere; put(row, sphere) appends its words.
template <typename Put>
void writeLines(AtomicFile& file, const ExportedRun& run, const ExportedFrame& frame, Put&& put)
{
    fmt::memory_buffer row;
    for (std::size_t i = 0; i < frame.state.states.size(); ++i)
    {
        row.clear();
        put(row, rowOf(run, frame, i));
        row.push_back('\n');
        file.write({row.data(), row.size()});
    }
}

} // namespace frostfill

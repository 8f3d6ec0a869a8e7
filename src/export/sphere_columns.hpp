// SPDX-License-Identifier: MIT
#pragma once

#include "export/exporter.hpp"
#include "output/atomic_file.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cstdint>
#include <iterator>
#include <string>
#include <tuple>

namespace frostfill
{

/// A sphere as files have it, in the world.
struct ExportedSphere
{
    std::uint32_t id = 0;       ///< order of appearance, from 0
    double x = 0, y = 0, z = 0; ///< centre [mesh unit]
    double radius = 0;          ///< [mesh unit]
    std::uint8_t state = 0;     ///< 0 running, 1 frozen, 2 discarded
    std::uint32_t group = 0;    ///< with which it appeared, from 0
    std::uint32_t set = 0;      ///< likewise
    float speed = 0;            ///< [mesh unit / s]
};

[[nodiscard]] inline ExportedSphere sphereOf(const ExportedRun& run, const ExportedFrame& frame,
                                             std::size_t i)
{
    const Eigen::Vector3d p = frame.centre(i);
    const Snapshot& state = frame.state;
    return {static_cast<std::uint32_t>(i),
            p.x(),
            p.y(),
            p.z(),
            frame.radii[i],
            static_cast<std::uint8_t>(state.states[i]),
            state.groups[i],
            state.groups[i] / run.groupsPerSet,
            state.speeds[i]};
}

template <typename Value>
struct ExportColumn
{
    const char* name;
    Value ExportedSphere::*value;
};

inline constexpr ExportColumn<std::uint32_t> kIdColumn{"id", &ExportedSphere::id};
inline constexpr std::tuple kPlaceColumns = {ExportColumn<double>{"x", &ExportedSphere::x},
                                             ExportColumn<double>{"y", &ExportedSphere::y},
                                             ExportColumn<double>{"z", &ExportedSphere::z}};
inline constexpr ExportColumn<double> kRadiusColumn{"radius", &ExportedSphere::radius};
inline constexpr std::tuple kStateColumns = {
    ExportColumn<std::uint8_t>{"state", &ExportedSphere::state},
    ExportColumn<std::uint32_t>{"group", &ExportedSphere::group},
    ExportColumn<std::uint32_t>{"set", &ExportedSphere::set},
    ExportColumn<float>{"speed", &ExportedSphere::speed}};

/// What formats of points have beside the place.
inline constexpr auto kPointColumns =
    std::tuple_cat(std::tuple(kRadiusColumn, kIdColumn), kStateColumns);
/// What tables have behind the number of a sphere.
inline constexpr auto kTableColumns =
    std::tuple_cat(kPlaceColumns, std::tuple(kRadiusColumn), kStateColumns);

/// Calls visit(column) for each column in turn.
template <typename Columns, typename Visit>
void forEachColumn(const Columns& columns, Visit&& visit)
{
    std::apply([&](const auto&... column) { (visit(column), ...); }, columns);
}

/// Appends the values of a sphere, each behind a separator, with the digits that read back to the
/// same bits.
template <typename Columns>
void putText(fmt::memory_buffer& row, const ExportedSphere& sphere, const Columns& columns,
             char separator)
{
    forEachColumn(columns,
                  [&](const auto& column)
                  {
                      row.push_back(separator);
                      fmt::format_to(std::back_inserter(row), FMT_COMPILE("{}"),
                                     sphere.*column.value);
                  });
}

/// Writes a line a sphere; put(row, sphere) appends its words.
template <typename Put>
void writeLines(AtomicFile& file, const ExportedRun& run, const ExportedFrame& frame, Put&& put)
{
    fmt::memory_buffer row;
    for (std::size_t i = 0; i < frame.state.states.size(); ++i)
    {
        row.clear();
        put(row, sphereOf(run, frame, i));
        row.push_back('\n');
        file.write({row.data(), row.size()});
    }
}

} // namespace frostfill

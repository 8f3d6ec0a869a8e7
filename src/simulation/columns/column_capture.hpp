// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/columns/world_columns.hpp"

#include <frostfill/snapshot.hpp>

#include <map>
#include <memory>
#include <vector>

namespace frostfill
{

[[nodiscard]] SphereRecord recordOf(const World& world, std::size_t id);

/// Gives snapshots the carried columns that they ask for. Costs nothing until one does.
class ColumnCapture
{
public:
    explicit ColumnCapture(const World& world) : world_(world) {}

    /// Brings the columns of a snapshot up to date, after all else in it. Adds to
    /// Snapshot::changed the spheres of which only a carried value changed.
    void fill(Snapshot& snapshot);
    /// Of all spheres as they are now.
    [[nodiscard]] std::vector<ColumnValues> all();

private:
    void fillColumn(ColumnValues& values, Snapshot& snapshot);
    [[nodiscard]] WorldColumn* sourceOf(const Column& column);
    [[nodiscard]] double valueOf(const Column& column, const WorldColumn* source,
                                 std::uint32_t id) const;

    const World& world_;
    std::map<const Column*, std::unique_ptr<WorldColumn>> sources_;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/columns/column_capture.hpp"

#include <vector>

namespace frostfill::test
{

/// A snapshot that has one column of a world.
class CapturedColumn
{
public:
    CapturedColumn(const World& world, const char* name) : world_(world), capture_(world)
    {
        snapshot_.columns.emplace_back(*findColumn(name));
    }

    /// Brings the column up to date. Returns the spheres whose value has changed, ascending.
    const std::vector<std::uint32_t>& capture()
    {
        snapshot_.resize(world_.spheres.size());
        snapshot_.changed.clear();
        capture_.fill(snapshot_);
        return snapshot_.changed;
    }

    [[nodiscard]] double operator[](std::size_t id) const { return snapshot_.columns[0].at(id); }

private:
    const World& world_;
    ColumnCapture capture_;
    Snapshot snapshot_;
};

} // namespace frostfill::test

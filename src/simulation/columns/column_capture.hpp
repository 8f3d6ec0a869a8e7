// SPDX-License-Identifier: MIT
// Room: the columns of spheres that a snapshot carries: where values come from, and how a snapshot
// gets them.
#pragma once

#include "simulation/world/world.hpp"

#include <frostfill/snapshot.hpp>

#include <map>
#include <vector>

namespace frostfill
{

[[nodiscard]] SphereRecord recordOf(const World& world, std::size_t id);

/// Gives snapshots the carried columns that they ask for. Costs nothing until one does.
class ColumnCapture
{
public:
    explicit ColumnCapture(const World& world) : world_(world) {}

    /// Brings the columns of a snapshot up to date, after all else in it. Adds the spheres whose
    /// value is another one now to Snapshot::changed.
    void fill(Snapshot& snapshot);

    /// Of all spheres as they are now.
    [[nodiscard]] std::vector<ColumnValues> all();

private:
    /// Values by row at rest, and all that they depend on.
    struct AtRest
    {
        std::size_t changes = 0; ///< of spheres' states
        Eigen::Vector3d pull;
        Eigen::Vector3d spin;
        std::vector<double> values = {};

        [[nodiscard]] bool isOf(const AtRest& moment) const
        {
            return changes == moment.changes && pull == moment.pull && spin == moment.spin;
        }
    };

    [[nodiscard]] const std::vector<double>* valuesAtRest(const Column& column);
    void update(ColumnValues& values, std::vector<std::uint32_t>& changed);

    const World& world_;
    std::map<const Column*, AtRest> atRest_;
};

} // namespace frostfill

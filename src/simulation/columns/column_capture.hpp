// SPDX-License-Identifier: MIT
// Room: the columns of spheres that a snapshot carries: where values come from, and how a snapshot
// gets them.
#pragma once

#include "simulation/world/world.hpp"

#include <frostfill/snapshot.hpp>

#include <optional>
#include <vector>

namespace frostfill
{

[[nodiscard]] SphereRecord recordOf(const World& world, std::size_t id);

/// Counts the contacts of all spheres at rest: see restingContacts(). It counts again beside
/// spheres that have come to rest or woken since, so a state costs what has changed.
class ContactCounts
{
public:
    explicit ContactCounts(const World& world) : world_(world) {}

    /// [#spheres] Returns the counts as of now, by id. With `once` it keeps no places if there are
    /// none yet: the next call counts all again.
    [[nodiscard]] const std::vector<double>& update(bool once);

private:
    void goThroughChanges(std::vector<char>& isOld);

    const World& world_;
    std::size_t seen_ = 0;                ///< changes of spheres' states
    std::vector<Eigen::Vector3d> places_; ///< by id, where it rested then; or nowhere
    std::vector<double> counts_;          ///< by id
};

/// Gives snapshots the carried columns that they ask for. Costs nothing until one does.
class ColumnCapture
{
public:
    explicit ColumnCapture(const World& world) : world_(world), contacts_(world) {}

    /// Brings the columns of a snapshot up to date, after all else in it. Adds the spheres whose
    /// value is another one now to Snapshot::changed.
    void fill(Snapshot& snapshot);

    /// Of all spheres as they are now.
    [[nodiscard]] std::vector<ColumnValues> all();

private:
    /// The unbalance of spheres at rest, by their rows, and all that it depends on.
    struct Unbalance
    {
        std::size_t changes = 0; ///< of spheres' states
        Eigen::Vector3d pull;
        Eigen::Vector3d spin;
        std::vector<double> values = {};

        [[nodiscard]] bool isOf(const Unbalance& moment) const
        {
            return changes == moment.changes && pull == moment.pull && spin == moment.spin;
        }
    };

    [[nodiscard]] const std::vector<double>& unbalances();
    void update(ColumnValues& values, std::vector<std::uint32_t>& changed, bool once = false);

    const World& world_;
    ContactCounts contacts_;
    std::optional<Unbalance> unbalance_;
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <simulation/reach_map.hpp>
#include <simulation/runner.hpp>
#include <simulation/world.hpp>

#include <memory>
#include <span>
#include <vector>

namespace frostfill
{

/// Discards what no running sphere can touch any more, and nothing else: the result is the same bit
/// for bit as without. See ReachMap for the rule and its proof. Every open cube inside the object
/// is taken for a place where a sphere may yet be released, so releases need no check of their own.
class ExactDiscard
{
public:
    explicit ExactDiscard(World& world);

    /// To be called for each sphere that has come to rest.
    void addResting(std::uint32_t id);

    /// Updates the reached set and drops what is out of it, once enough spheres have come to rest
    /// since the last time; that is decided from counts, never from the clock.
    void updateWhenDue(std::span<const Runner> runners)
    {
        if (pending_ >= batch_)
        {
            update(runners);
        }
    }
    void update(std::span<const Runner> runners);

private:
    void build();
    void drop();
    void restoreAll();

    World& world_;
    std::unique_ptr<ReachMap> map_;
    double margin_ = 1; ///< factor on the margins, doubled each time a guard trips
    std::size_t pending_ = 0;
    std::size_t batch_ = 1;
    struct Kept
    {
        std::uint32_t id;
        ReachMap::Cursor cursor;
    };
    std::vector<Kept> kept_; ///< spheres at rest that are not dropped
    std::vector<Eigen::Vector3d> centres_;
};

} // namespace frostfill

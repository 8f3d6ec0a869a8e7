// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/freezing/rest_followers.hpp"
#include "simulation/freezing/runners.hpp"

#include <vector>

namespace frostfill
{

/// Clears the place at which a sphere is to come to rest of the runners that it would overlap
/// there.
class RoomMaker
{
public:
    RoomMaker(World& world, Runners& runners, RestFollowers& followers)
        : world_(world), runners_(runners), followers_(followers)
    {
    }

    /// Moves the runners that a sphere at this place, itself runner `index`, would overlap to clear
    /// places at most `farthest` [own radius] away. Returns false, and moves none, when one of them
    /// cannot be moved.
    [[nodiscard]] bool makeRoom(std::uint32_t index, const PlacedSphere& resting, double farthest);

    /// The last resort after makeRoom has failed and the sphere is at rest all the same: the others
    /// appear again elsewhere, or are withdrawn when the object is full.
    void evict();

private:
    void findOverlapped(std::uint32_t index, const PlacedSphere& resting);
    void withdraw(Runner& runner);

    World& world_;
    Runners& runners_;
    RestFollowers& followers_;
    std::vector<std::uint32_t> overlapped_; ///< runners in the way, ascending
    std::vector<Eigen::Vector3d> moved_;    ///< where they are put
};

} // namespace frostfill

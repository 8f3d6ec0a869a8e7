// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/contact/runner_grid.hpp"
#include "simulation/freezing/rest_observers.hpp"
#include "simulation/motion/free_flight.hpp"

#include <algorithm>
#include <vector>

namespace frostfill
{

/// Clears the place at which a sphere is to come to rest of the runners that it would overlap
/// there.
class OverlapResolver
{
public:
    OverlapResolver(World& world, RunnerGrid& grid, FreeFlight& flight, RestObservers& observers)
        : world_(world), running_(world.spheres.running()), grid_(grid), flight_(flight),
          observers_(observers)
    {
    }

    /// Finds out ahead, on any thread, which runners moveAside() will meet, and returns whether
    /// there are any. makeReady() comes before, for so many runners.
    bool lookForOverlapped(std::uint32_t row, const PlacedSphere& resting);
    /// After that, where they can go among what is at rest now.
    void lookForRoom(std::uint32_t row, const PlacedSphere& resting, double farthest);
    void makeReady(std::size_t runners) { ahead_.resize(std::max(runners, ahead_.size())); }

    /// Moves the runners that a sphere at this place, itself in this row, would overlap to clear
    /// places at most `farthest` [own radius] away. Returns false, and moves none, when one of them
    /// cannot be moved. What was found out ahead is taken if it still holds.
    [[nodiscard]] bool moveAside(std::uint32_t row, const PlacedSphere& resting, double farthest);

    /// The last resort after moveAside has failed and the sphere is at rest all the same: the
    /// others appear again elsewhere, or are withdrawn when the object is full.
    void evict();

    /// Rows of those that were in the way at last, ascending.
    [[nodiscard]] std::span<const std::uint32_t> overlapped() const { return room_.overlapped; }

private:
    /// Where those can go that a sphere overlaps.
    struct Room
    {
        std::vector<std::uint32_t> overlapped; ///< their rows, ascending
        std::vector<Eigen::Vector3d> from;     ///< where they are, as far as is known
        std::vector<Eigen::Vector3d> to;       ///< where they can be put
        bool found = false;                    ///< for each of them
        std::size_t atRest = 0;                ///< spheres among which that was found
        // Builds of the grid at which that was found out, and which were in the way. 0: not yet.
        std::uint64_t foundAt = 0;
        std::uint64_t lookedAt = 0;
    };

    void findOverlapped(std::uint32_t row, const PlacedSphere& resting);
    void findOverlapped(std::uint32_t row, const PlacedSphere& resting,
                        std::vector<std::uint32_t>& overlapped) const;
    void findRoom(const PlacedSphere& resting, double farthest, Room& room) const;
    [[nodiscard]] bool stillHolds(const Room& ahead, double farthest) const;
    void put(std::uint32_t row, const Eigen::Vector3d& place);
    void withdraw(std::uint32_t row);

    World& world_;
    RunningSpheres& running_;
    RunnerGrid& grid_;
    FreeFlight& flight_;
    RestObservers& observers_;
    std::vector<Room> ahead_;     ///< [#runners]
    Room room_;                   ///< of the sphere whose turn it is
    std::uint64_t stirredAt_ = 0; ///< build of the grid in which a runner was last put elsewhere
};

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/motion/free_flight.hpp"
#include "simulation/release/release_rule.hpp"

#include <span>
#include <vector>

namespace frostfill
{

/// Clears the place at which a sphere is to come to rest of the runners that it would overlap
/// there.
class OverlapResolver
{
public:
    OverlapResolver(World& world, SphereGrid& grid, FreeFlight& flight,
                    const std::unique_ptr<ReleasePart>& release)
        : world_(world), running_(world.spheres.running()), grid_(grid), flight_(flight),
          release_(release)
    {
    }

    /// Moves the runners that a sphere at this place, itself in this row, would overlap to clear
    /// places at most `farthest` [own radius] away. Returns false, and moves none, when one of them
    /// cannot be moved.
    [[nodiscard]] bool moveAside(std::uint32_t row, const PlacedSphere& resting, double farthest);

    /// The last resort after moveAside has failed and the sphere is at rest all the same: the
    /// others appear again elsewhere, or are withdrawn when the object is full.
    void evict();

    /// Rows of those that were in the way at last, ascending.
    [[nodiscard]] std::span<const std::uint32_t> overlapped() const { return overlapped_; }

private:
    void findOverlapped(std::uint32_t row, const PlacedSphere& resting);
    void put(std::uint32_t row, const Eigen::Vector3d& place);

    World& world_;
    RunningSpheres& running_;
    SphereGrid& grid_;
    FreeFlight& flight_;
    const std::unique_ptr<ReleasePart>& release_;
    std::vector<std::uint32_t> overlapped_;
    std::vector<Eigen::Vector3d> to_; ///< where those can be put
};

} // namespace frostfill

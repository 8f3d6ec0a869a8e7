// SPDX-License-Identifier: MIT
#pragma once

#include <simulation/world.hpp>

#include <cstdint>
#include <vector>

namespace frostfill
{

/// Finds places at which spheres can appear: inside the object, near the top of the space that is
/// left, clear of the walls and of every sphere, discarded ones included. Places are looked for
/// from a lattice of half a radius; each lattice point stands for the places within its cell and is
/// forgotten when spheres at rest have taken them all.
class ReleaseSearch
{
public:
    /// `world` outlives this.
    explicit ReleaseSearch(const World& world);

    /// Up to `count` places for the spheres with the next ids, clear of each other too. Fewer when
    /// no more is free.
    [[nodiscard]] std::vector<Eigen::Vector3d> find(std::size_t count);

private:
    [[nodiscard]] bool takenForGood(const Eigen::Vector3d& site) const;
    [[nodiscard]] bool moveClear(Eigen::Vector3d& p, const Eigen::Vector3d& site) const;
    [[nodiscard]] bool clearOfRunning(const Eigen::Vector3d& p,
                                      const std::vector<Eigen::Vector3d>& released) const;

    const World& world_;
    GridFrame lattice_;
    std::vector<std::uint32_t> sites_; ///< lattice cells still of use, from the top down
    std::uint64_t draws_ = 0;
};

} // namespace frostfill

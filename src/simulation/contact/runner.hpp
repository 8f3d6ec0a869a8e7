// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/contact/neighbour_list.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace frostfill
{

/// A running sphere of the fast engine, with all that its motion needs close together.
struct Runner
{
    static constexpr std::uint32_t kNobody = 0xffffffff; ///< id of one whose sphere is gone

    std::uint32_t id = kNobody;
    double radius = 1;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();

    NeighbourList around;                 ///< what is at rest near it
    std::vector<std::uint32_t> nearby;    ///< runners near it, by index, ascending
    std::vector<Eigen::Vector3d> normals; ///< of its contacts, scratch

    Eigen::Vector3d flown = Eigen::Vector3d::Zero();          ///< position after this step's flight
    Eigen::Vector3d velocityBefore = Eigen::Vector3d::Zero(); ///< at the end of that flight
    Eigen::Vector3d watched = Eigen::Vector3d::Zero();        ///< position at the window's start
    double height = 0;      ///< against the pull, while it is in a pair [r]
    std::uint32_t rank = 0; ///< from below, among the runners in pairs
    double age = 0;         ///< since its release, or something came to rest beside it [sqrt(r/g)]
    std::uint32_t stillWindows = 0;           ///< in a row in which it hardly moved
    std::optional<Eigen::Vector3d> carriedAt; ///< the place nearby where what is at rest carries it
    bool stale = false;  ///< something has come to rest, or has moved, since carriedAt was found
    bool member = false; ///< of the island in question, see SupportIsland
    bool falls = false;  ///< the island does not carry it, scratch
    bool yields = true;  ///< gives way to other runners; one that nothing carries for long does not

    void restart(std::uint32_t newId, const Eigen::Vector3d& p, double newRadius);
};

} // namespace frostfill

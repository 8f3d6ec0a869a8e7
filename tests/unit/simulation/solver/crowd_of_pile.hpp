// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.hpp"
#include "simulation/solver/turns.hpp"
#include "unit/simulation/solver/pile.hpp"

#include <vector>

namespace frostfill
{

/// Runners one beside the other, shaken, some pressed into others.
inline std::vector<Eigen::Vector3d> shakenPlaces(std::uint64_t seed)
{
    std::vector<Eigen::Vector3d> places;
    for (std::uint64_t k = 0; k < 343; ++k)
    {
        const auto at = [&](std::uint64_t n, std::uint64_t axis)
        { return 1.95 * (static_cast<double>(n) - 3) + 0.4 * uniformRandom(seed, k, axis) - 0.2; };
        places.emplace_back(at(k % 7, 0), at(k / 49, 1) - 1, at(k / 7 % 7, 2));
    }
    return places;
}

/// Pairs of runners far from one another, pressed into one another, and one of `longest`.
inline std::vector<Eigen::Vector3d> clusters(std::uint64_t seed, int longest = 2)
{
    std::vector<Eigen::Vector3d> places;
    for (std::uint64_t k = 0; k < 64; ++k)
    {
        const auto at = [&](std::uint64_t n, std::uint64_t axis)
        { return 3.9 * (static_cast<double>(n) - 1.5) + 0.2 * uniformRandom(seed, k, axis); };
        places.emplace_back(at(k % 4, 0), at(k / 16, 1), at(k / 4 % 4, 2));
        places.emplace_back(places.back() + Eigen::Vector3d(0.2, 0.5, 0.1));
    }
    for (int k = 2; k < longest; ++k)
    {
        places.emplace_back(places[1] + 1e-3 * k * Eigen::Vector3d(1, 0, 0));
    }
    return places;
}

/// A crowd of all runners of a pile.
struct CrowdOfPile
{
    explicit CrowdOfPile(std::size_t strips) : CrowdOfPile(strips, shakenPlaces(1), 1) {}
    CrowdOfPile(std::size_t strips, const std::vector<Eigen::Vector3d>& places, double radius)
        : pile(places, std::vector<double>(places.size(), radius), strips)
    {
        pairs.findPairs();
        crowd.gather({0, -1, 0});
        crowd.arrange();
        turns.start();
    }

    Pile pile;
    BroadPhase pairs{pile.running, pile.threads};
    Crowd crowd{pile.running, pairs, pile.threads};
    Turns turns{crowd};
};

} // namespace frostfill

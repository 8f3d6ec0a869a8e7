// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/contact/footprint.hpp"
#include "simulation/release/tolerances.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace frostfill
{

/// What a draw of a ceiling leads to. A thread that takes draws reads one line of memory of each;
/// the footprint is for the thread that computes them, mostly another one.
struct alignas(64) Draw
{
    /// Which one, for a sphere of which radius.
    struct Key
    {
        std::uint64_t number = 0;
        std::uint32_t site = 0;
        double radius = 0; ///< [r]

        bool operator==(const Key&) const = default;
    };
    Key key;
    std::optional<Eigen::Vector3d> place; ///< clear, then prepared; empty where there is none
    bool isLookedAt = false;              ///< its site is: either open or, by isKnown, taken
    bool isKnown = false;                 ///< all is
    bool stays = false;                   ///< what is prepared there can stay
    std::uint64_t blockedIn = 0;          ///< the search in which it does not suit, if not 0
    Footprint seen;                       ///< where they were looked for

    /// From its ceiling nothing more can be released.
    [[nodiscard]] bool endsCeiling() const { return isKnown && !(place && stays); }
    /// Until it is looked for again, its footprint is of no meaning.
    void forget()
    {
        isLookedAt = false;
        isKnown = false;
    }
};

/// What is known of draws to come. Draws are independent of each other but where one comes to rest
/// within another's footprint, so they are found out on all threads at once, and taken in order.
/// One that a sphere at rest has made void since is found out again: speculation with an ordered
/// commit, as a processor does with its reorder buffer [Smith & Pleszkun 1985].
class Lookahead
{
public:
    /// The draw, if it is known.
    [[nodiscard]] const Draw* find(const Draw::Key& key) const
    {
        if (key.number > last_)
        {
            return nullptr;
        }
        const Draw& draw = draws_[key.number % kMostAhead];
        return draw.key == key && draw.isKnown ? &draw : nullptr;
    }

    /// The same, and a draw that is yet to be found out if there is none. Numbers in use are fewer
    /// than kMostAhead apart.
    [[nodiscard]] Draw& expect(const Draw::Key& key);

    /// A sphere has come to rest: voids the draws after `number` that may come out differently.
    void voidNear(const Eigen::Vector3d& centre, double radius, std::uint64_t number);

private:
    std::vector<Draw> draws_; ///< [kMostAhead] by number; none before one is expected
    std::uint64_t last_ = 0;  ///< number of the last that was expected
};

} // namespace frostfill

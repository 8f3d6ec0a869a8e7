// SPDX-License-Identifier: MIT
#pragma once

#include "base/buckets.hpp"
#include "base/threads.hpp"
#include "simulation/solver/broad_phase.hpp"
#include "simulation/world/sphere_grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Runners that the solvers visit one after another, and their neighbours. Data that a solver reads
/// of successive members lie side by side in memory.
///
/// The places of the members alone cut a large crowd into slabs along a horizontal axis. A sweep
/// visits every other slab at the same time, then the slabs between, and in each slab the lowest
/// member first. A slab is more than twice as wide as any pair, so that two members that are
/// visited at the same time have no neighbour in common: a visit may change the member and its
/// neighbours. The number of threads therefore changes no bit.
class Crowd
{
public:
    /// A neighbour of a member.
    struct Near
    {
        std::uint32_t slot : 31;
        std::uint32_t isLower : 1;
    };
    /// Members with successive slots, the lowest first.
    struct Slab
    {
        std::uint32_t begin;
        std::uint32_t end;
    };

    Crowd(RunningSpheres& running, const BroadPhase& pairs, Threads& threads)
        : running_(running), pairs_(pairs), threads_(threads)
    {
    }

    /// Gathers all runners that are in a pair. `down`: direction of the pull.
    void gather(const Eigen::Vector3d& down);
    /// Gathers these rows only, as if there were no others.
    void gather(std::span<const std::uint32_t> rows, const Eigen::Vector3d& down);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(rows_.size()); }
    [[nodiscard]] const std::vector<Slab>& slabs() const { return slabs_; }

    // By slot.
    [[nodiscard]] const Ball& operator[](std::uint32_t slot) const { return balls_[slot]; }
    [[nodiscard]] std::uint32_t row(std::uint32_t slot) const { return rows_[slot]; }
    /// Returns the member's neighbours, by ascending row.
    [[nodiscard]] std::span<const Near> near(std::uint32_t slot) const
    {
        return {nearby_.data() + firstNear_[slot], nearCount_[slot]};
    }
    /// Takes over the place to which the runner has been moved.
    void follow(std::uint32_t slot)
    {
        const Eigen::Vector3d& p = running_.position[rows_[slot]];
        balls_[slot] = {p.x(), p.y(), p.z(), balls_[slot].radius};
    }

    /// Calls body(k) for each slab: every other one first, then the slabs between.
    template <class Body>
    void sweep(Body&& body) const
    {
        forEachSlab(threads_, static_cast<int>(slabs_.size()),
                    [&](int k) { body(static_cast<std::size_t>(k)); });
    }
    /// Calls body(slot) for each member. The body may change that member only.
    template <class Body>
    void forEachMember(Body&& body) const
    {
        threads_.forEachSmall(size(),
                              [&](std::size_t slot) { body(static_cast<std::uint32_t>(slot)); });
    }
    [[nodiscard]] Threads& threads() const { return threads_; }

private:
    static constexpr std::uint32_t kNone = 0xffffffff;
    static constexpr std::uint32_t kLargestSlot = 0x7fffffff;

    struct Member
    {
        double height; ///< against the pull [r]
        std::uint32_t row;
        std::uint32_t slab;
    };
    [[nodiscard]] static bool isBelow(const Member& a, const Member& b);
    void enter(std::uint32_t row);
    void arrange();
    void cut();
    [[nodiscard]] double longestPair(int axis) const;
    void sortIntoSlabs();
    void enlist(std::uint32_t slot);

    RunningSpheres& running_;
    const BroadPhase& pairs_;
    Threads& threads_;
    Eigen::Vector3d down_ = {0, -1, 0};
    std::vector<Member> gathered_; ///< by row
    std::vector<Slab> slabs_;
    // By slot.
    Buckets<Member> members_; ///< by slab
    std::vector<Ball> balls_;
    std::vector<std::uint32_t> rows_;
    std::vector<std::size_t> firstNear_;
    std::vector<std::uint32_t> nearCount_;
    std::vector<Near> nearby_;
    std::vector<std::uint32_t> slot_; ///< by row
};

} // namespace frostfill

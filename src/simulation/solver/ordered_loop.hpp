// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/solver/broad_phase.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace frostfill
{

/// Visits runners on all threads as if one by one, the lowest rank first: one has its turn once
/// those before it are done that are near it. A visit may read what belongs to those nearby and
/// write what is its own, so the result is that of one thread, bit for bit: a Gauss-Seidel sweep as
/// a wavefront [Lamport 1974].
///
/// A thread has the runners of one region, a slab of the object, in the order of their ranks. So
/// only those at a border ever wait, and cores exchange only what lies there, as long as what a
/// visit writes is kept by slot. Whoever has to wait for long goes on in another region that nobody
/// has in hand: a thread that is late stops no other.
class OrderedLoop
{
public:
    OrderedLoop(const RunningSpheres& running, const BroadPhase& pairs, Threads& threads)
        : running_(running), pairs_(pairs), threads_(threads)
    {
    }

    /// The rows of the loops to come, in order of their ranks. `rank`: by row; what is not among
    /// the rows has a higher one than all of them.
    void prepare(std::span<const std::uint32_t> rows, std::span<const std::uint32_t> rank);

    /// The place of a row among all of them, region by region. Of no other row.
    [[nodiscard]] std::uint32_t slot(std::uint32_t row) const { return slots_[row]; }
    [[nodiscard]] std::span<const std::uint32_t> rowBySlot() const { return order_; }

    /// Calls visit(row) for each of the rows. What a visit throws is thrown on.
    template <class Visit>
    void forEach(Visit&& visit)
    {
        if (regions_.empty())
        {
            std::for_each(order_.begin(), order_.end(), visit);
            return;
        }
        start();
        threads_.forEachLarge(regions_.size(), [&](std::size_t own) { work(own, visit); });
    }

private:
    /// Rows, below which threads cost more than they gain.
    static constexpr std::size_t kWorthSharing = 512;
    /// Looks for one's turn before another region is looked at.
    static constexpr int kPatience = 2000;

    /// A runner at a border, and one across it that comes before it.
    struct Need
    {
        std::uint32_t slot;
        std::uint32_t region;
        std::uint32_t before; ///< slot of the other one
    };
    struct alignas(64) Region
    {
        std::atomic<std::uint32_t> next = 0; ///< slot; all before it, of the region, are done
        std::atomic<bool> inHand = false;
        // Of whoever has it in hand.
        std::uint32_t first = 0;
        std::uint32_t end = 0;
        std::size_t met = 0;     ///< needs
        std::vector<Need> needs; ///< ascending by slot
    };

    void divide(std::span<const std::uint32_t> rows);
    void findNeeds(std::uint32_t region, std::span<const std::uint32_t> rank);
    void start();
    [[nodiscard]] bool waitFor(const Need& need) const;

    // In its own region first.
    template <class Visit>
    void work(std::size_t own, Visit&& visit)
    {
        for (std::size_t tries = 0; left_ > 0 && !failed_; ++tries)
        {
            Region& region = regions_[(own + tries) % regions_.size()];
            if (region.next != region.end &&
                !region.inHand.exchange(true, std::memory_order_acquire))
            {
                advance(region, visit);
                region.inHand.store(false, std::memory_order_release);
            }
        }
    }

    template <class Visit>
    void advance(Region& region, Visit&& visit)
    {
        std::uint32_t at = region.next.load(std::memory_order_relaxed);
        if (at == region.end)
        {
            return; // another has just done it
        }
        try
        {
            for (; at < region.end; region.next.store(++at, std::memory_order_release))
            {
                for (; region.met < region.needs.size() && region.needs[region.met].slot == at;
                     ++region.met)
                {
                    if (!waitFor(region.needs[region.met]))
                    {
                        return;
                    }
                }
                visit(order_[at]);
            }
        }
        catch (...)
        {
            failed_ = true; // nobody waits for the rest
            throw;
        }
        --left_;
    }

    const RunningSpheres& running_;
    const BroadPhase& pairs_;
    Threads& threads_;
    std::vector<std::uint32_t> order_; ///< rows by slot
    std::vector<std::uint32_t> slots_; ///< by row
    std::deque<Region> regions_;       ///< one for each thread; none where one thread does it all
    std::vector<std::uint32_t> regionOf_; ///< by row
    std::vector<double> borders_;         ///< along x
    std::atomic<std::size_t> left_ = 0;   ///< regions
    std::atomic<bool> failed_ = false;
};

} // namespace frostfill

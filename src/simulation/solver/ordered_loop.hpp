// SPDX-License-Identifier: MIT
#pragma once

#include "base/threads.hpp"
#include "simulation/solver/broad_phase.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace frostfill
{

/// Visits runners on all threads as if one by one, the lowest rank first: one has its turn once
/// those before it are done that are near it. A visit may read what belongs to those nearby and
/// write what is its own, so the result is that of one thread, bit for bit. Runners of about the
/// same height are mostly far from each other, so threads hardly ever wait: a Gauss-Seidel sweep as
/// a wavefront [Lamport 1974], without levels that all have to finish.
class OrderedLoop
{
public:
    OrderedLoop(const BroadPhase& pairs, Threads& threads) : pairs_(pairs), threads_(threads) {}

    /// Calls visit(row) for each of `rows`, which are in order of their ranks. `rank`: by row; what
    /// is not among the rows has a higher one than all of them. What a visit throws is thrown on.
    template <class Visit>
    void forEach(std::span<const std::uint32_t> rows, std::span<const std::uint32_t> rank,
                 Visit&& visit)
    {
        if (rows.size() < kWorthSharing || threads_.concurrency() == 1)
        {
            std::for_each(rows.begin(), rows.end(), visit);
            return;
        }
        done_.assign(rank.size(), 0);
        next_ = 0;
        failed_ = false;
        // Each takes the next few that nobody has taken, until none are left.
        threads_.forEachLarge(threads_.concurrency(),
                              [&](std::size_t)
                              {
                                  for (std::size_t at = take(); at < rows.size(); at = take())
                                  {
                                      const std::size_t end = std::min(rows.size(), at + kAtOnce);
                                      visitInTurn(rows.subspan(at, end - at), rank, visit);
                                  }
                              });
    }

private:
    /// Rows, below which threads cost more than they gain.
    static constexpr std::size_t kWorthSharing = 256;
    /// Rows that a thread takes. Larger: it waits for others more often. Smaller: they get into
    /// each other's way.
    static constexpr std::size_t kAtOnce = 16;

    [[nodiscard]] std::size_t take() { return next_.fetch_add(kAtOnce, std::memory_order_relaxed); }

    template <class Visit>
    void visitInTurn(std::span<const std::uint32_t> rows, std::span<const std::uint32_t> rank,
                     Visit&& visit)
    {
        try
        {
            for (const std::uint32_t row : rows)
            {
                waitForTurn(row, rank);
                visit(row);
                std::atomic_ref(done_[row]).store(1, std::memory_order_release);
            }
        }
        catch (...)
        {
            failed_ = true; // nobody waits for the rest
            throw;
        }
    }
    void waitForTurn(std::uint32_t row, std::span<const std::uint32_t> rank)
    {
        for (const std::uint32_t other : pairs_.nearby(row))
        {
            for (int spin = 0; rank[other] < rank[row] && !isDone(other) && !failed_; ++spin)
            {
                pauseAfter(spin);
            }
        }
    }
    [[nodiscard]] bool isDone(std::uint32_t row)
    {
        return std::atomic_ref(done_[row]).load(std::memory_order_acquire) != 0;
    }

    const BroadPhase& pairs_;
    Threads& threads_;
    std::vector<char> done_; ///< by row
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> failed_ = false;
};

} // namespace frostfill

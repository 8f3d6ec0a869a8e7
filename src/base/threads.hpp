// SPDX-License-Identifier: MIT
// Room: the tools below everything else: threads, random numbers, statistics, timing, other
// programs. Nothing here knows of spheres or meshes.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <vector>

namespace frostfill
{

/// Threads for the loops of a simulation. A loop's body may write only what belongs to its own
/// index, so that results do not depend on the number of threads. One loop at a time.
///
/// A step has a dozen loops of some 50 us each with serial work between them, so short that waking
/// a thread takes as long as its share of the work: threads look for the next loop for a while
/// before they sleep, and a loop never waits for a thread that has not begun to help.
///
/// oneTBB's parallel_for in place of this takes 1.04 to 1.07 times as long for a cube of 10,000 and
/// one of 100,000 spheres on two cores (`--motion skip --frames none`, medians of 6 and 3 runs, the
/// best of four partitioners), and a thread sanitizer cannot look into it.
class Threads
{
public:
    /// 0 takes as many as there are cores.
    explicit Threads(int count);
    /// `atOnce`: gather() always returns this, however few cores there are, and asleep or not.
    Threads(int count, std::size_t atOnce) : Threads(count) { atOnce_ = atOnce; }
    ~Threads();
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    [[nodiscard]] std::size_t concurrency() const { return concurrency_; }

    /// Calls body(i) for each i below `count`; on this thread when there are fewer than are worth
    /// sharing, which depends on how long one takes. What a body throws is thrown on.
    template <class Body>
    void forEach(std::size_t count, Body&& body, std::size_t worthSharing = kWorthSharing)
    {
        if (count < worthSharing || concurrency_ == 1)
        {
            for (std::size_t i = 0; i < count; ++i)
            {
                body(i);
            }
            return;
        }
        const auto run = [](const void* loop, std::size_t i)
        { (*static_cast<std::remove_reference_t<Body>*>(const_cast<void*>(loop)))(i); };
        share(count, run, &body);
    }

    /// The same for few bodies that take long.
    template <class Body>
    void forEachLarge(std::size_t count, Body&& body)
    {
        forEach(count, body, 2);
    }

    /// Wakes all threads. Returns how many bodies forEachAtOnce may be given so that none waits for
    /// a core, nor, unless they take long, for a thread that has yet to wake up.
    std::size_t gather(bool takeLong);
    /// Calls body(i) for each i below `count`, at most what gather() has returned, each on a thread
    /// of its own, so that bodies may wait for one another.
    template <class Body>
    void forEachAtOnce(std::size_t count, Body&& body)
    {
        forEachLarge(count, body);
    }
    /// For a body of such a loop: returns once isSo(), and throws if another body has thrown.
    template <class Condition>
    void waitUntil(Condition&& isSo) const
    {
        for (int spin = 0; !isSo(); ++spin)
        {
            if (failed_)
            {
                throw std::runtime_error("another thread of the same loop has failed");
            }
            pauseAfter(spin % kSpins);
        }
    }

private:
    using Run = void (*)(const void* body, std::size_t i);

    /// What a thread is to do of a loop, on lines of memory that others only touch to hand it over,
    /// or to take some of it once they have nothing left to do.
    struct alignas(64) Share
    {
        /// The parts that nobody has taken yet, and of which loop they are: see the source. Who
        /// has taken one reads the rest, which stays as it is until the loop is over.
        std::atomic<std::uint64_t> parts = 0;
        std::atomic<Run> run = nullptr;
        std::atomic<const void*> body = nullptr;
        std::atomic<std::size_t> count = 0;     ///< bodies of the whole loop
        std::atomic<std::size_t> partCount = 0; ///< parts of the whole loop
        /// Parts that this thread has done so far, of all loops: told once it finds no more, and
        /// read only by who waits for the end.
        alignas(64) std::atomic<std::size_t> done = 0;
    };

    void start();
    void share(std::size_t count, Run run, const void* body);
    void handOut(std::uint64_t partCount, std::size_t count, Run run, const void* body);
    [[nodiscard]] bool isOver() const;
    void help(std::size_t self);
    void takeParts(std::size_t self);
    std::size_t takeFrom(std::size_t owner, std::size_t self);
    void runPart(const Share& loop, std::size_t part);
    static void pauseAfter(int spin);

    static constexpr std::size_t kWorthSharing = 32;
    static constexpr int kSpins = 20000; ///< for work before a thread sleeps: some 200 us

    std::size_t concurrency_;
    std::size_t cores_;
    std::size_t atOnce_ = 0;           ///< 0: as many as are awake and have a core
    std::vector<std::thread> helpers_; ///< begin with the first loop that is shared
    std::unique_ptr<Share[]> shares_;  ///< that of the leading thread, then the helpers'
    std::uint64_t loops_ = 0;          ///< so far
    std::size_t handedOut_ = 0;        ///< parts of all loops so far

    alignas(64) std::atomic<std::size_t> awake_ = 0; ///< helpers that look for work, or do some
    std::atomic<bool> over_ = false;
    std::atomic<bool> failed_ = false; ///< a body of this loop
    std::mutex failureLock_;
    std::exception_ptr failure_; ///< the first that a body has thrown
};

/// Calls body(first, last, part) for parts of `size`, the last one of what is left: few bodies that
/// take long, and sums over parts that do not depend on the number of threads.
template <class Body>
void forEachPart(Threads& threads, std::size_t count, std::size_t size, Body&& body)
{
    threads.forEachLarge((count + size - 1) / size, [&](std::size_t part)
                         { body(part * size, std::min(count, (part + 1) * size), part); });
}

/// Calls body(slab) for each slab below `count`: every other one first, then those between, so that
/// a body may also write what belongs to the slabs beside its own.
template <class Body>
void forEachSlab(Threads& threads, int count, Body&& body)
{
    for (const int first : {0, 1})
    {
        threads.forEachLarge(static_cast<std::size_t>((count - first + 1) / 2),
                             [&](std::size_t i) { body(first + 2 * static_cast<int>(i)); });
    }
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
// Room: the tools below everything else: threads, random numbers, statistics, timing, other
// programs. Nothing here knows of spheres or meshes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace frostfill
{

/// Threads of oneTBB for the loops of a simulation. A loop's body may write only what belongs to
/// its own index, so that results do not depend on the number of threads. One loop at a time, but a
/// body may begin another.
class Threads
{
public:
    /// `count`: threads that a loop takes at most, of those that oneTBB has for this process. 0: as
    /// many as there are cores at hand.
    explicit Threads(int count);
    ~Threads();
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    [[nodiscard]] std::size_t concurrency() const { return concurrency_; }

    /// Calls body(i) for each i below `count`; on this thread when there are fewer than are worth
    /// sharing, which depends on how long one takes. Throws what a body throws.
    template <class Body>
    void forEach(std::size_t count, Body&& body, std::size_t worthSharing = kWorthSharing)
    {
        const auto run = [](const void* loop, std::size_t first, std::size_t end)
        {
            auto& each = *static_cast<std::remove_reference_t<Body>*>(const_cast<void*>(loop));
            for (std::size_t i = first; i < end; ++i)
            {
                each(i);
            }
        };
        count < worthSharing || concurrency_ == 1 ? run(&body, 0, count) : share(count, run, &body);
    }

    /// The same for few bodies that take long.
    template <class Body>
    void forEachLarge(std::size_t count, Body&& body)
    {
        forEach(count, body, 2);
    }
    /// The same for bodies that take less than a microsecond.
    template <class Body>
    void forEachSmall(std::size_t count, Body&& body)
    {
        forEach(count, body, 1024);
    }

private:
    using Run = void (*)(const void* body, std::size_t first, std::size_t end);
    void share(std::size_t count, Run run, const void* body);

    static constexpr std::size_t kWorthSharing = 32;

    std::size_t concurrency_;
    struct Arena;                  // no header of oneTBB here: most of the sources include this one
    std::unique_ptr<Arena> arena_; ///< begins with the first loop that is shared
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

// SPDX-License-Identifier: MIT
#include "base/threads.hpp"

#include "base/cores.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace frostfill
{
namespace
{

// Threads::Share::parts, from its lowest bit: the end of the parts that are left, the first of
// them, loops so far. A part is taken only by changing that word, so none is ever taken twice, or
// of a loop that is over.
constexpr int kPartBits = 16;
constexpr std::uint64_t kPartMask = (std::uint64_t{1} << kPartBits) - 1;

struct Parts
{
    std::uint64_t loop;
    std::uint64_t first;
    std::uint64_t end;

    static Parts of(std::uint64_t word)
    {
        return {word >> (2 * kPartBits), word >> kPartBits & kPartMask, word & kPartMask};
    }
    [[nodiscard]] std::uint64_t word() const
    {
        return loop << (2 * kPartBits) | first << kPartBits | end;
    }
};

constexpr std::size_t kPartsPerThread = 8; // so that one that is slow does not hold up the loop
constexpr int kSpinsBeforeYield = 100;     // before others may have the core

} // namespace

Threads::Threads(int count)
    : concurrency_(count > 0 ? static_cast<std::size_t>(count)
                             : static_cast<std::size_t>(coresAtHand())),
      cores_(static_cast<std::size_t>(coresAtHand()))
{
}

void Threads::pauseAfter(int spin)
{
    if (spin % kSpinsBeforeYield == kSpinsBeforeYield - 1)
    {
        std::this_thread::yield();
        return;
    }
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

Threads::~Threads()
{
    over_ = true;
    if (!helpers_.empty())
    {
        handOut(0, 0, nullptr, nullptr);
    }
    for (std::thread& helper : helpers_)
    {
        helper.join();
    }
}

std::size_t Threads::gather(bool takeLong)
{
    start();
    const std::size_t awake = awake_.load(std::memory_order_acquire);
    if (awake < helpers_.size())
    {
        handOut(0, 0, nullptr, nullptr); // idle helpers go on looking for a loop
    }
    return atOnce_ > 0 ? atOnce_ : std::min(1 + (takeLong ? helpers_.size() : awake), cores_);
}

void Threads::start()
{
    if (!shares_)
    {
        shares_ = std::make_unique<Share[]>(concurrency_);
    }
    try
    {
        while (helpers_.size() + 1 < concurrency_)
        {
            helpers_.emplace_back([this, self = helpers_.size() + 1] { help(self); });
        }
    }
    catch (const std::system_error&)
    {
        concurrency_ = helpers_.size() + 1; // where no more can be started, fewer do the same
    }
}

void Threads::share(std::size_t count, Run run, const void* body)
{
    start();
    const std::uint64_t partCount =
        std::min<std::uint64_t>({count, kPartsPerThread * concurrency_, kPartMask});
    handedOut_ += partCount;
    handOut(partCount, count, run, body);
    takeParts(0);
    for (int spin = 0; !isOver(); ++spin)
    {
        pauseAfter(spin % kSpins);
    }
    if (failure_)
    {
        failed_ = false;
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

// To each thread parts side by side, the same share of each loop: from loop to loop an index mostly
// stays with the core that has its data.
void Threads::handOut(std::uint64_t partCount, std::size_t count, Run run, const void* body)
{
    ++loops_;
    const std::uint64_t takers = std::min<std::uint64_t>(partCount, helpers_.size() + 1);
    for (std::size_t k = 0; k <= helpers_.size(); ++k)
    {
        Share& share = shares_[k];
        share.run.store(run, std::memory_order_relaxed);
        share.body.store(body, std::memory_order_relaxed);
        share.count.store(count, std::memory_order_relaxed);
        share.partCount.store(partCount, std::memory_order_relaxed);
        Parts parts = {loops_, 0, 0};
        if (k < takers)
        {
            parts.first = partCount * k / takers;
            parts.end = partCount * (k + 1) / takers;
        }
        share.parts.store(parts.word(), std::memory_order_release);
    }
    // Who goes to sleep says so, and then looks once more: either it is seen here, or it sees this.
    if (awake_.fetch_add(0, std::memory_order_acq_rel) < helpers_.size())
    {
        for (std::size_t k = 1; k <= helpers_.size(); ++k)
        {
            shares_[k].parts.notify_all();
        }
    }
}

bool Threads::isOver() const
{
    std::size_t done = 0;
    for (std::size_t k = 0; k <= helpers_.size(); ++k)
    {
        done += shares_[k].done.load(std::memory_order_acquire);
    }
    return done == handedOut_;
}

void Threads::help(std::size_t self)
{
    const std::atomic<std::uint64_t>& parts = shares_[self].parts;
    std::uint64_t seen = 0; // loops
    const auto isNew = [&]
    { return Parts::of(parts.load(std::memory_order_acquire)).loop != seen; };
    ++awake_;
    while (!over_)
    {
        for (int spin = 0; spin < kSpins && !isNew(); ++spin)
        {
            pauseAfter(spin);
        }
        if (isNew())
        {
            seen = Parts::of(parts.load(std::memory_order_acquire)).loop;
            takeParts(self);
            continue;
        }
        awake_.fetch_sub(1, std::memory_order_acq_rel);
        for (std::uint64_t old = parts.load(std::memory_order_acquire);
             Parts::of(old).loop == seen && !over_; old = parts.load(std::memory_order_acquire))
        {
            parts.wait(old, std::memory_order_acquire);
        }
        ++awake_;
    }
}

// First one's own, then what others have left. The loop is not over before its parts are told.
void Threads::takeParts(std::size_t self)
{
    const std::size_t all = concurrency_;
    std::size_t done = 0;
    for (std::size_t k = 0; k < all; ++k)
    {
        done += takeFrom((self + k) % all, self);
    }
    if (done > 0)
    {
        std::atomic<std::size_t>& told = shares_[self].done;
        told.store(told.load(std::memory_order_relaxed) + done, std::memory_order_release);
    }
}

// The leading thread takes its own parts from the front and helpers theirs from the back, where
// loops may have what takes long. Others take half of what is left, from the other end.
std::size_t Threads::takeFrom(std::size_t owner, std::size_t self)
{
    Share& loop = shares_[owner];
    std::size_t done = 0;
    std::uint64_t word = loop.parts.load(std::memory_order_acquire);
    for (Parts left = Parts::of(word); left.first < left.end; left = Parts::of(word))
    {
        const std::uint64_t some = owner == self ? 1 : (left.end - left.first + 1) / 2;
        const bool fromFront = (owner == 0) == (owner == self);
        const std::uint64_t first = fromFront ? left.first : left.end - some;
        (fromFront ? left.first : left.end) = fromFront ? first + some : first;
        if (!loop.parts.compare_exchange_weak(word, left.word(), std::memory_order_acq_rel,
                                              std::memory_order_acquire))
        {
            continue;
        }
        for (std::uint64_t part = first; part < first + some; ++part)
        {
            runPart(loop, part);
        }
        done += some;
        word = loop.parts.load(std::memory_order_acquire);
    }
    return done;
}

void Threads::runPart(const Share& loop, std::size_t part)
{
    const std::size_t count = loop.count.load(std::memory_order_relaxed);
    const std::size_t all = loop.partCount.load(std::memory_order_relaxed);
    try
    {
        const Run run = loop.run.load(std::memory_order_relaxed);
        const void* body = loop.body.load(std::memory_order_relaxed);
        for (std::size_t i = count * part / all; i < count * (part + 1) / all; ++i)
        {
            run(body, i);
        }
    }
    catch (...)
    {
        const std::lock_guard lock(failureLock_);
        failure_ = failure_ ? failure_ : std::current_exception();
        failed_ = true;
    }
}

} // namespace frostfill

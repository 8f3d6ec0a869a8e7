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

// Threads::state_, from its lowest bit: parts taken from the front, parts taken from the back,
// parts of the loop, loops so far.
constexpr int kPartBits = 12;
constexpr std::uint64_t kPartMask = (std::uint64_t{1} << kPartBits) - 1;
constexpr std::size_t kPartsPerThread = 8; // so that one that is slow does not hold up the loop
constexpr int kSpinsBeforeYield = 100;     // before others may have the core

std::uint64_t atFront(std::uint64_t state)
{
    return state & kPartMask;
}
std::uint64_t atBack(std::uint64_t state)
{
    return state >> kPartBits & kPartMask;
}
std::uint64_t parts(std::uint64_t state)
{
    return state >> (2 * kPartBits) & kPartMask;
}
bool allTaken(std::uint64_t state)
{
    return atFront(state) + atBack(state) == parts(state);
}

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
    state_.fetch_add(std::uint64_t{1} << (3 * kPartBits));
    state_.notify_all();
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
        // A loop without parts: whoever looks for one goes on looking.
        const std::uint64_t loop = (state_.load(std::memory_order_relaxed) >> (3 * kPartBits)) + 1;
        state_.store(loop << (3 * kPartBits), std::memory_order_release);
        state_.notify_all();
    }
    return atOnce_ > 0 ? atOnce_ : std::min(1 + (takeLong ? helpers_.size() : awake), cores_);
}

void Threads::start()
{
    try
    {
        while (helpers_.size() + 1 < concurrency_)
        {
            helpers_.emplace_back([this] { help(); });
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
    run_.store(run, std::memory_order_relaxed);
    body_.store(body, std::memory_order_relaxed);
    count_.store(count, std::memory_order_relaxed);
    partsDone_.store(0, std::memory_order_relaxed);
    const std::uint64_t wanted =
        std::min<std::uint64_t>({count, kPartsPerThread * concurrency_, kPartMask});
    const std::uint64_t loop = (state_.load(std::memory_order_relaxed) >> (3 * kPartBits)) + 1;
    state_.store(loop << (3 * kPartBits) | wanted << (2 * kPartBits), std::memory_order_release);
    state_.notify_all();
    takeParts(true);
    for (int spin = 0; partsDone_.load(std::memory_order_acquire) != wanted; ++spin)
    {
        pauseAfter(spin % kSpins);
    }
    if (failure_)
    {
        failed_ = false;
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

void Threads::help()
{
    ++awake_;
    std::uint64_t seen = state_.load(std::memory_order_acquire);
    while (!over_)
    {
        if (takeParts(false))
        {
            continue;
        }
        seen = state_.load(std::memory_order_acquire);
        for (int spin = 0; spin < kSpins && allTaken(seen) && !over_; ++spin)
        {
            pauseAfter(spin);
            seen = state_.load(std::memory_order_acquire);
        }
        if (allTaken(seen) && !over_)
        {
            --awake_;
            state_.wait(seen, std::memory_order_acquire);
            ++awake_;
        }
    }
}

// The leading thread begins at the front and the helpers at the back, so that from loop to loop an
// index mostly stays with the core that has its data. Returns false when no part was left. The loop
// is not over before its parts have been told.
bool Threads::takeParts(bool front)
{
    const std::uint64_t one = front ? 1 : std::uint64_t{1} << kPartBits;
    std::size_t done = 0;
    std::uint64_t state = state_.load(std::memory_order_acquire);
    while (!allTaken(state))
    {
        if (state_.compare_exchange_weak(state, state + one, std::memory_order_acq_rel,
                                         std::memory_order_acquire))
        {
            runPart(front ? atFront(state) : parts(state) - 1 - atBack(state), parts(state));
            ++done;
            state = state_.load(std::memory_order_acquire);
        }
    }
    if (done > 0)
    {
        partsDone_.fetch_add(done, std::memory_order_release);
    }
    return done > 0;
}

void Threads::runPart(std::size_t part, std::size_t all)
{
    const std::size_t count = count_.load(std::memory_order_relaxed);
    try
    {
        const Run run = run_.load(std::memory_order_relaxed);
        const void* body = body_.load(std::memory_order_relaxed);
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

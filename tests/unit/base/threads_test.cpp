// SPDX-License-Identifier: MIT
#include "base/threads.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace frostfill
{
namespace
{

// As many as the tests ask for, however few cores there are.
const tbb::global_control kThreads(tbb::global_control::max_allowed_parallelism, 8);

class ThreadsTest : public testing::TestWithParam<int>
{
protected:
    Threads threads{GetParam()};
};

// Loops of every length, one right after the other: a thread that is late must not take a part of
// the loop before, or of the one after.
TEST_P(ThreadsTest, VisitEachIndexOnce)
{
    EXPECT_EQ(threads.concurrency(), static_cast<std::size_t>(GetParam()));
    for (const std::size_t count : {0U, 1U, 2U, 31U, 32U, 33U, 1000U, 4095U, 4097U, 100000U})
    {
        for (int repeat = 0; repeat < 50; ++repeat)
        {
            std::vector<int> visits(count, 0);
            threads.forEach(count, [&](std::size_t i) { ++visits[i]; });
            ASSERT_EQ(std::count(visits.begin(), visits.end(), 1),
                      static_cast<std::ptrdiff_t>(count));
        }
    }
}

TEST_P(ThreadsTest, TakePartsOfAFixedSizeAndTheLastOfWhatIsLeft)
{
    for (const std::size_t count : {0U, 1U, 9U, 10U, 11U, 95U})
    {
        std::vector<std::size_t> partOf(count, 99);
        forEachPart(threads, count, 10,
                    [&](std::size_t first, std::size_t last, std::size_t part)
                    {
                        EXPECT_LE(last, count);
                        std::fill(partOf.data() + first, partOf.data() + last, part);
                    });
        for (std::size_t i = 0; i < count; ++i)
        {
            EXPECT_EQ(partOf[i], i / 10) << i << " of " << count;
        }
    }
}

TEST_P(ThreadsTest, ThrowWhatABodyThrowsAndGoOn)
{
    for (int repeat = 0; repeat < 50; ++repeat)
    {
        EXPECT_THROW(threads.forEach(1000,
                                     [](std::size_t i)
                                     {
                                         if (i % 300 == 299)
                                         {
                                             throw std::runtime_error("no room");
                                         }
                                     }),
                     std::runtime_error);
        std::atomic<int> done = 0;
        threads.forEach(1000, [&](std::size_t) { ++done; });
        ASSERT_EQ(done, 1000);
    }
}

TEST_P(ThreadsTest, TakeNoMoreThanAskedFor)
{
    std::atomic<std::size_t> busy = 0;
    std::atomic<std::size_t> most = 0;
    threads.forEach(100,
                    [&](std::size_t)
                    {
                        const std::size_t now = ++busy;
                        for (std::size_t before = most;
                             before < now && !most.compare_exchange_weak(before, now);)
                        {
                        }
                        std::this_thread::sleep_for(std::chrono::milliseconds(1));
                        --busy;
                    });
    EXPECT_LE(most, threads.concurrency());
}

// One thread is held up by the first body or the last, until all others but a few beside it are
// done: for some seconds at most.
TEST_P(ThreadsTest, DoWhatOneThatIsHeldUpCannotDo)
{
    constexpr std::size_t kCount = 1000;
    for (const std::size_t slow : {std::size_t{0}, kCount - 1})
    {
        std::atomic<std::size_t> done = 0;
        bool alone = false;
        const auto isDone = [&] { return done >= kCount - kCount / 8; };
        threads.forEach(kCount,
                        [&](std::size_t i)
                        {
                            if (i == slow)
                            {
                                const int looks = threads.concurrency() > 1 ? 10'000'000 : 0;
                                for (int look = 0; look < looks && !isDone(); ++look)
                                {
                                    std::this_thread::yield();
                                }
                                alone = !isDone();
                            }
                            ++done;
                        });
        EXPECT_EQ(done, kCount);
        EXPECT_EQ(alone, threads.concurrency() == 1 && slow == 0);
    }
}

// So that no slab is visited beside one that still is.
TEST_P(ThreadsTest, VisitEveryOtherSlabBeforeThoseBetween)
{
    for (const int count : {1, 2, 41, 42})
    {
        std::vector<int> order(static_cast<std::size_t>(count), -1);
        std::atomic<int> visits = 0;
        forEachSlab(threads, count,
                    [&](int slab) { order[static_cast<std::size_t>(slab)] = visits++; });
        EXPECT_EQ(visits, count);
        for (std::size_t slab = 0; slab < order.size(); ++slab)
        {
            EXPECT_EQ(order[slab] < (count + 1) / 2, slab % 2 == 0) << slab << " of " << count;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(OneToFive, ThreadsTest, testing::Values(1, 2, 3, 5),
                         testing::PrintToStringParamName());

// Two bodies that wait for each other, for some seconds at most.
TEST(Threads, DoTwoThingsAtOnce)
{
    Threads threads(2);
    std::atomic<int> here = 0;
    std::atomic<int> met = 0;
    threads.forEachLarge(2,
                         [&](std::size_t)
                         {
                             ++here;
                             for (int look = 0; here < 2 && look < 10'000'000; ++look)
                             {
                                 std::this_thread::yield();
                             }
                             met += here == 2 ? 1 : 0;
                         });
    EXPECT_EQ(met, 2);
}

// More threads than can be started are no reason for a warning of oneTBB.
TEST(Threads, SayNothingOfMoreThanThereAre)
{
    Threads threads(64);
    testing::internal::CaptureStderr();
    std::atomic<int> done = 0;
    threads.forEach(1000, [&](std::size_t) { ++done; });
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(done, 1000);
}

TEST(Threads, LeaveALoopThatIsTooShortToTheCaller)
{
    Threads threads(4);
    std::set<std::thread::id> seen;
    threads.forEach(31, [&](std::size_t) { seen.insert(std::this_thread::get_id()); });
    EXPECT_EQ(seen, std::set<std::thread::id>{std::this_thread::get_id()});
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "base/ordered_worker.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

namespace frostfill
{
namespace
{

TEST(OrderedWorker, DoesJobsInTheirOrder)
{
    std::vector<int> done;
    OrderedWorker worker(2);
    for (int i = 0; i < 500; ++i)
    {
        worker.push([&done, i] { done.push_back(i); });
    }
    worker.finish();
    ASSERT_EQ(done.size(), 500u);
    for (int i = 0; i < 500; ++i)
    {
        EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
    }
}

TEST(OrderedWorker, LetsNoMoreJobsWaitThanItsLimit)
{
    std::atomic<int> open = 0;
    std::atomic<int> most = 0;
    OrderedWorker worker(1);
    for (int i = 0; i < 200; ++i)
    {
        worker.push(
            [&]
            {
                std::this_thread::sleep_for(std::chrono::microseconds(200));
                --open;
            });
        // The one being done, the one that waits, and the one that was pushed just now.
        most = std::max<int>(most, ++open);
    }
    worker.finish();
    EXPECT_LE(most, 3);
    EXPECT_GE(most, 1);
}

TEST(OrderedWorker, TellsWhatHasGoneWrongAndDoesNoMore)
{
    OrderedWorker worker(1);
    std::atomic<int> later = 0;
    worker.push([] { throw std::runtime_error("the disk is full"); });
    EXPECT_THROW(
        {
            for (int i = 0; i < 10; ++i)
            {
                worker.push([&] { ++later; });
            }
        },
        std::runtime_error);
    EXPECT_THROW(worker.finish(), std::runtime_error);
    EXPECT_EQ(later, 0);
}

TEST(OrderedWorker, CanBeGivenUpWhileJobsWait)
{
    std::atomic<int> done = 0;
    {
        OrderedWorker worker(50);
        for (int i = 0; i < 50; ++i)
        {
            worker.push(
                [&]
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                    ++done;
                });
        }
    }
    EXPECT_LT(done, 50);
}

} // namespace
} // namespace frostfill

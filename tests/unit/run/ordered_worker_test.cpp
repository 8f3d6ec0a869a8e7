// SPDX-License-Identifier: MIT
#include "run/ordered_worker.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
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
    OrderedWorker worker;
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

TEST(OrderedWorker, LetsOneJobWaitAndNoMore)
{
    std::promise<void> gate;
    OrderedWorker worker;
    worker.push([opened = gate.get_future().share()] { opened.wait(); });
    worker.push([] {}); // does not wait for the first one to end, or this would be all
    std::atomic<bool> pushed = false;
    std::thread another(
        [&]
        {
            worker.push([] {});
            pushed = true;
        });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_FALSE(pushed);
    gate.set_value();
    another.join();
    EXPECT_TRUE(pushed);
    worker.finish();
}

TEST(OrderedWorker, TellsWhatHasGoneWrongAndDoesNoMore)
{
    OrderedWorker worker;
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

TEST(OrderedWorker, CanBeGivenUpWhileAJobWaits)
{
    std::atomic<int> done = 0;
    {
        OrderedWorker worker;
        for (int i = 0; i < 2; ++i)
        {
            worker.push(
                [&]
                {
                    std::this_thread::sleep_for(std::chrono::milliseconds(50));
                    ++done;
                });
        }
    }
    EXPECT_LT(done, 2);
}

} // namespace
} // namespace frostfill

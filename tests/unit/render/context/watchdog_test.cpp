// SPDX-License-Identifier: MIT
#include "render/context/context.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace frostfill
{
namespace
{

using namespace std::chrono_literals;

TEST(WatchdogDeathTest, EndsTheProcessWithItsMessageWhenItLivesForTooLong)
{
    EXPECT_EXIT(
        {
            const Watchdog watchdog(20ms, "it hangs", 69);
            std::this_thread::sleep_for(60s);
        },
        testing::ExitedWithCode(69), "it hangs");
}

TEST(Watchdog, DoesNothingWhenWhatItGuardsEnds)
{
    {
        const Watchdog watchdog(20ms, "it hangs", 69);
    }
    std::this_thread::sleep_for(60ms);
}

} // namespace
} // namespace frostfill

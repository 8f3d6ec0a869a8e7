// SPDX-License-Identifier: MIT
#include "base/watchdog.hpp"

#include "base/memory_at_hand.hpp"

#include <gtest/gtest.h>

#include <cstdint>

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

TEST(MemoryAtHand, MayBeMappedAndNoMoreThanThereCanBe)
{
    EXPECT_TRUE(mayMap(1 << 20));
    EXPECT_FALSE(mayMap(SIZE_MAX / 2));
}

} // namespace
} // namespace frostfill

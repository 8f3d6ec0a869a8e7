// SPDX-License-Identifier: MIT
#include "base/memory_at_hand.hpp"

#include "base/sanitized.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdint>
#include <cstdlib>

namespace frostfill
{
namespace
{

constexpr std::size_t kGigabyte = std::size_t{1} << 30;

TEST(MemoryAtHand, IsMoreThanWhatThisTestTakesAndLessThanAnyMachineHas)
{
    EXPECT_GT(memoryAtHand(), 1e8);
    EXPECT_LT(memoryAtHand(), 1e15);
}

TEST(MemoryAtHand, MayBeMappedAndNoMoreThanThereCanBe)
{
    EXPECT_TRUE(mayMap(1 << 20));
    EXPECT_FALSE(mayMap(SIZE_MAX / 2));
}

TEST(MemoryAtHandDeathTest, MayNotBeMappedBeyondALimitOnTheAddressSpace)
{
#ifdef FROSTFILL_SANITIZED
    GTEST_SKIP() << "a sanitizer maps more than any limit";
#endif
    EXPECT_EXIT(
        {
            const bool before = mayMap(4 * kGigabyte);
            rlimit limit;
            limit.rlim_cur = limit.rlim_max = 2 * kGigabyte;
            const bool set = setrlimit(RLIMIT_AS, &limit) == 0;
            std::exit(before && set && mayMap(1 << 20) && !mayMap(4 * kGigabyte) ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace frostfill

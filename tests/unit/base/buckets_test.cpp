// SPDX-License-Identifier: MIT
#include "base/buckets.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

TEST(Buckets, HaveTheirValuesInTheOrderInWhichTheyCame)
{
    const std::vector<std::pair<std::size_t, int>> all = {{3, 7}, {0, 5}, {3, 1}, {1, 9}, {3, 4}};
    const Buckets<int> buckets(5,
                               [&](auto&& enter)
                               {
                                   for (const auto& [bucket, value] : all)
                                   {
                                       enter(bucket, value);
                                   }
                               });
    EXPECT_EQ(buckets.starts(), (std::vector<std::uint32_t>{0, 1, 2, 2, 5, 5}));
    const std::span<const int> values = buckets.values();
    EXPECT_EQ(std::vector<int>(values.begin(), values.end()), (std::vector<int>{5, 9, 7, 1, 4}));
    EXPECT_EQ(buckets[3].size(), 3U);
    EXPECT_EQ(buckets[3][0], 7);
    EXPECT_TRUE(buckets[4].empty());
    EXPECT_EQ(Buckets<int>().size(), 0U);
}

} // namespace
} // namespace frostfill

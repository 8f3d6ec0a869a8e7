// SPDX-License-Identifier: MIT
#include "base/statistics.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace frostfill
{
namespace
{

// The oracle is the definition: the least value that so many of all do not exceed.
TEST(Statistics, PercentilesAreValuesThatTheirShareDoesNotExceed)
{
    for (std::size_t count = 1; count <= 50; ++count)
    {
        for (const int percent : {1, 25, 50, 95, 99, 100})
        {
            std::vector<double> values(count);
            std::iota(values.rbegin(), values.rend(), 1.0);
            std::size_t rank = 1; // as many values do not exceed the one of this rank
            while (100 * rank < static_cast<std::size_t>(percent) * count)
            {
                ++rank;
            }
            EXPECT_EQ(percentile(values, percent / 100.0), static_cast<double>(rank))
                << percent << " % of " << count;
        }
    }
}

} // namespace
} // namespace frostfill

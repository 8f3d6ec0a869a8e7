// SPDX-License-Identifier: MIT
#include "fps/repeats.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace frostfill
{
namespace
{

TEST(Repeats, PercentilesAreNearestRanks)
{
    std::vector<double> values(200);
    std::iota(values.rbegin(), values.rend(), 1.0);
    const Distribution described = describe(values);
    EXPECT_EQ(described.count, 200u);
    EXPECT_DOUBLE_EQ(described.mean, 100.5);
    EXPECT_EQ(described.median, 100);
    EXPECT_EQ(described.p95, 190);
    EXPECT_EQ(described.p99, 198);
    EXPECT_EQ(described.least, 1);
    EXPECT_EQ(described.greatest, 200);
}

TEST(Repeats, ASingleValueIsAllOfItsPercentiles)
{
    const Distribution described = describe({7});
    EXPECT_EQ(described.median, 7);
    EXPECT_EQ(described.p99, 7);
    EXPECT_EQ(describe({}).count, 0u);
    EXPECT_EQ(describe({}).p95, 0);
}

// Worked by hand: mean 5, sample deviation sqrt(20/3), t for three degrees of freedom 3.182.
TEST(Repeats, TheConfidenceIntervalIsStudents)
{
    const RepeatedMean found = meanOfRepeats(std::vector<double>{2, 4, 6, 8});
    EXPECT_DOUBLE_EQ(found.mean, 5);
    EXPECT_NEAR(found.halfWidth, 3.182 * std::sqrt(20.0 / 3) / 2, 1e-12);
    EXPECT_EQ(found.least, 2);
}

// Quantiles by Boost.Math 1.74. n runs of -1 and 1 in turn have the deviation sqrt(n / (n - 1)).
TEST(Repeats, TheConfidenceIntervalIsStudentsForManyRunsToo)
{
    for (const auto& [runs, quantile] :
         {std::pair{32, 2.0395134463964082}, std::pair{102, 1.9837310029556059},
          std::pair{1002, 1.9623367052808796}})
    {
        std::vector<double> values;
        values.reserve(static_cast<std::size_t>(runs));
        for (int i = 0; i < runs; ++i)
        {
            values.push_back(i % 2 == 0 ? -1 : 1);
        }
        EXPECT_NEAR(meanOfRepeats(values).halfWidth * std::sqrt(runs - 1.0), quantile, 2e-6)
            << runs;
    }
}

TEST(Repeats, OneRunHasNoInterval)
{
    const RepeatedMean found = meanOfRepeats(std::vector<double>{3});
    EXPECT_EQ(found.mean, 3);
    EXPECT_EQ(found.halfWidth, 0);
}

} // namespace
} // namespace frostfill

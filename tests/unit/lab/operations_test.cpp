// SPDX-License-Identifier: MIT
#include "lab/operations.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

TEST(OperationsStudy, EverySetAgreesWithTheLemmas)
{
    for (const std::uint64_t k : {1, 2})
    {
        for (const bool discards : {false, true})
        {
            const OperationsResult result = measureOperations(
                {.object = "torus", .gamma = 5, .k = k, .discards = discards, .groups = 12});
            ASSERT_EQ(result.rows.size(), 12 / k);
            for (const OperationsRow& row : result.rows)
            {
                EXPECT_TRUE(row.agrees()) << "k " << k << ", beta " << row.beta;
            }
            EXPECT_EQ(result.rows.back().beta, 12u);
        }
    }
}

TEST(OperationsStudy, DiscardsAreSeenAndSaveTests)
{
    const auto measured = [](bool discards)
    {
        return measureOperations(
            {.object = "torus", .gamma = 5, .k = 1, .discards = discards, .groups = 60});
    };
    const OperationsRow with = measured(true).rows.back();
    const OperationsRow without = measured(false).rows.back();
    EXPECT_EQ(without.alpha, 0u);
    EXPECT_GT(with.alpha, 0u);
    EXPECT_EQ(without.sphereTests - with.sphereTests, with.alpha * 25);
}

TEST(OperationsStudy, AMiscountIsNoticed)
{
    OperationsRow row =
        measureOperations({.object = "cube", .gamma = 3, .k = 1, .discards = false, .groups = 2})
            .rows.back();
    ASSERT_TRUE(row.agrees());
    ++row.sphereTests;
    EXPECT_FALSE(row.agrees());
}

} // namespace
} // namespace frostfill

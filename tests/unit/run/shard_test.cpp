// SPDX-License-Identifier: MIT
#include "base/resources.hpp"
#include "support/expect_error.hpp"

#include <frostfill/shard.hpp>

#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>
#include <map>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;

/// The variables of a task of a job array, as Slurm sets them.
void setArray(const std::map<std::string, std::string>& values)
{
    for (const char* name : {"ID", "MIN", "MAX", "STEP", "COUNT"})
    {
        const std::string variable = std::string("SLURM_ARRAY_TASK_") + name;
        const auto found = values.find(name);
        if (found == values.end())
        {
            unsetenv(variable.c_str());
        }
        else
        {
            setenv(variable.c_str(), found->second.c_str(), 1);
        }
    }
}

TEST(Shard, AllPartsTogetherAreEveryTaskOnce)
{
    for (const std::size_t all : {0U, 1U, 7U, 16U, 24U, 200U, 1001U})
    {
        for (const std::size_t count : {1U, 2U, 3U, 16U, 300U})
        {
            std::vector<int> owned(all, 0);
            std::vector<int> ranged(all, 0);
            for (std::size_t index = 0; index < count; ++index)
            {
                const Shard shard = {index, count};
                const auto [first, end] = shard.range(all);
                EXPECT_LE(end - first, all / count + 1);
                for (std::size_t k = 0; k < all; ++k)
                {
                    owned[k] += shard.owns(k) ? 1 : 0;
                    ranged[k] += k >= first && k < end ? 1 : 0;
                }
            }
            EXPECT_EQ(owned, std::vector<int>(all, 1)) << all << " in " << count;
            EXPECT_EQ(ranged, std::vector<int>(all, 1)) << all << " in " << count;
        }
    }
}

TEST(Shard, IsReadAsTheFirstOfSixteen)
{
    EXPECT_EQ(parseShard("1/16"), (Shard{0, 16}));
    EXPECT_EQ(parseShard("16/16"), (Shard{15, 16}));
    for (const char* wrong : {"", "3", "0/16", "17/16", "1/0", "-1/4", "1/4x", "a/b", "1/", "/4"})
    {
        expectError(
            ErrorCode::usage, [&] { (void)parseShard(wrong); }, "1/16 for the first");
    }
}

TEST(Shard, IsThatOfTheTaskOfASlurmArray)
{
    setArray({{"ID", "7"}, {"MIN", "1"}, {"MAX", "13"}, {"STEP", "3"}, {"COUNT", "5"}});
    EXPECT_EQ(parseShard("slurm"), (Shard{2, 5}));
    setArray({{"ID", "15"}, {"MIN", "0"}, {"MAX", "15"}, {"STEP", "1"}, {"COUNT", "16"}});
    EXPECT_EQ(parseShard("slurm"), (Shard{15, 16}));
}

TEST(Shard, SaysWhatIsMissingOutsideOfAnArray)
{
    setArray({});
    expectError(
        ErrorCode::usage, [] { (void)parseShard("slurm"); }, "SLURM_ARRAY_TASK_ID is not set");
    setArray({{"ID", "3"}, {"MIN", "0"}, {"MAX", "15"}, {"STEP", "1"}});
    expectError(
        ErrorCode::usage, [] { (void)parseShard("slurm"); }, "SLURM_ARRAY_TASK_COUNT is not set");
}

TEST(Shard, RefusesAListOfTasksOfWhichNobodyKnowsTheOrder)
{
    setArray({{"ID", "7"}, {"MIN", "3"}, {"MAX", "12"}, {"STEP", "1"}, {"COUNT", "3"}});
    expectError(
        ErrorCode::usage, [] { (void)parseShard("slurm"); }, "whole range",
        "what is complete is skipped");
}

TEST(CoresAtHand, AreNoMoreThanTheProcessIsBoundToOrSlurmHasGiven)
{
    unsetenv("SLURM_CPUS_PER_TASK");
    unsetenv("SLURM_CPUS_ON_NODE");
    cpu_set_t before;
    ASSERT_EQ(sched_getaffinity(0, sizeof(before), &before), 0);
    const int all = coresAtHand();
    EXPECT_GE(all, 1);
    EXPECT_LE(all, CPU_COUNT(&before));
    setenv("SLURM_CPUS_ON_NODE", "1", 1);
    EXPECT_EQ(coresAtHand(), 1);
    setenv("SLURM_CPUS_PER_TASK", "1000", 1);
    EXPECT_EQ(coresAtHand(), all); // what Slurm says of the task comes first
    int first = 0;
    while (!CPU_ISSET(first, &before))
    {
        ++first;
    }
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
    EXPECT_EQ(coresAtHand(), 1);
    ASSERT_EQ(sched_setaffinity(0, sizeof(before), &before), 0);
}

} // namespace
} // namespace frostfill

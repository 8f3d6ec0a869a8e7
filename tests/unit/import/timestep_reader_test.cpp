// SPDX-License-Identifier: MIT
#include "packing/timestep_reader.hpp"

#include "unit/import/imported_run.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using test::dumpStep;

class TimestepReaderTest : public ::testing::Test
{
protected:
    [[nodiscard]] std::vector<Timestep> read(const std::string& text)
    {
        test::writeFile(folder_ / "file", text);
        TimestepReader reader(folder_ / "file", 0);
        std::vector<Timestep> timesteps;
        for (Timestep timestep; reader.next(timestep);)
        {
            timesteps.push_back(timestep);
        }
        torn_ = reader.torn();
        return timesteps;
    }
    test::TemporaryFolder folder_;
    std::string torn_;
};

TEST_F(TimestepReaderTest, GivesWhatTheFileSays)
{
    const auto timesteps =
        read("ITEM: UNITS\nsi\nITEM: TIME\n0.25\n" +
             dumpStep(7, "id x y z radius state group", {"5 0 1 2 0.5 discarded 3"}));
    ASSERT_EQ(timesteps.size(), 1U);
    EXPECT_EQ(timesteps[0].time, 0.25);
    EXPECT_EQ(timesteps[0].step, 7U);
    EXPECT_EQ(timesteps[0].ids, (std::vector<std::uint64_t>{5}));
    EXPECT_EQ(timesteps[0].states, (std::vector<SphereState>{SphereState::discarded}));
    EXPECT_EQ(timesteps[0].groups, (std::vector<std::uint32_t>{3}));
    ASSERT_TRUE(timesteps[0].box);
    EXPECT_EQ(timesteps[0].box->max(), Eigen::Vector3d(1, 1, 1));
    EXPECT_EQ(torn_, "");
}

TEST_F(TimestepReaderTest, KnowsStatesByNameAndByNumber)
{
    const auto timesteps =
        read(dumpStep(7, "id x y z radius state",
                      {"1 0 0 0 1 running", "2 0 0 0 1 frozen", "3 0 0 0 1 discarded",
                       "4 0 0 0 1 0", "5 0 0 0 1 1", "6 0 0 0 1 2"}));
    const std::vector<SphereState> states = {SphereState::running, SphereState::frozen,
                                             SphereState::discarded};
    ASSERT_EQ(timesteps.size(), 1U);
    for (std::size_t k = 0; k < 6; ++k)
    {
        EXPECT_EQ(timesteps[0].states.at(k), states[k % 3]) << k;
    }
}

TEST_F(TimestepReaderTest, MeasuresSpeedAlongAllThreeAxes)
{
    const auto timesteps = read(dumpStep(7, "id x y z radius vx vy vz", {"1 0 0 0 1 2 3 6"}));
    EXPECT_EQ(timesteps.at(0).speeds, (std::vector<double>{7}));
}

TEST_F(TimestepReaderTest, LeavesOutALastLineWithoutItsEnd)
{
    const std::string step = dumpStep(7, "id x y z radius", {"5 0 1 2 0.5", "6 0 1 2 0.25"});
    EXPECT_EQ(read(step + step).size(), 2U);
    EXPECT_EQ(torn_, "");
    // 0.2 for 0.25 would be a number too.
    EXPECT_EQ(read(step + step.substr(0, step.size() - 2)).size(), 1U);
    EXPECT_NE(torn_.find("incomplete"), std::string::npos) << torn_;
    EXPECT_EQ(read(step + "ITEM: TIMESTEP\n8\n").size(), 1U);
    EXPECT_NE(torn_.find("heading"), std::string::npos) << torn_;
}

} // namespace
} // namespace frostfill

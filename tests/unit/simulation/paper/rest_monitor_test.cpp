// SPDX-License-Identifier: MIT
#include "simulation/paper/paper_engine.hpp"
#include "simulation/world/spheres.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

/// Two spheres that are watched over windows of three steps.
class RestMonitorTest : public ::testing::Test
{
protected:
    RestMonitorTest()
    {
        spheres.add({0, 0, 0}, 1, 0);
        spheres.add({5, 0, 0}, 1, 0);
        monitor.restart(spheres.running());
    }
    bool observe(const std::vector<bool>& touched)
    {
        return monitor.observe(spheres.running(), touched, [](std::uint32_t) { return false; });
    }

    Spheres spheres;
    RestMonitor monitor{3, 0.1};
};

TEST_F(RestMonitorTest, CallsThoseAtRestThatTouchAndStay)
{
    EXPECT_FALSE(observe({true, false}));
    spheres.running().position[1] = {5, 0.09, 0};
    EXPECT_FALSE(observe({false, true}));
    EXPECT_TRUE(observe({false, false}));
}

TEST_F(RestMonitorTest, CallsNoneAtRestAtTheTopOfItsBounce)
{
    EXPECT_FALSE(observe({true, false}));
    EXPECT_FALSE(observe({true, false}));
    EXPECT_FALSE(observe({true, false}));
}

TEST_F(RestMonitorTest, CallsNoneAtRestThatLeftItsPlaceAndCameBack)
{
    EXPECT_FALSE(observe({true, true}));
    spheres.running().position[0] = {0, 0.11, 0};
    EXPECT_FALSE(observe({true, true}));
    spheres.running().position[0] = {0, 0, 0};
    EXPECT_FALSE(observe({true, true}));
    // A new window, in which both stay.
    EXPECT_FALSE(observe({true, true}));
    EXPECT_FALSE(observe({true, true}));
    EXPECT_TRUE(observe({true, true}));
}

TEST_F(RestMonitorTest, LeavesOutThoseThatAreLost)
{
    spheres.running().position[0] = {0, -1000, 0};
    const auto isLost = [](std::uint32_t id) { return id == 0; };
    EXPECT_FALSE(monitor.observe(spheres.running(), {false, true}, isLost));
    EXPECT_FALSE(monitor.observe(spheres.running(), {false, true}, isLost));
    EXPECT_TRUE(monitor.observe(spheres.running(), {false, true}, isLost));
}

} // namespace
} // namespace frostfill

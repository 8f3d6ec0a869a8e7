// SPDX-License-Identifier: MIT
#include "simulation/freezing/support_at_rest.hpp"

#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace frostfill
{
namespace
{

/// Spheres of radius 1 at rest in a box whose floor is at y = -8.
class SupportAtRestTest : public ::testing::Test
{
protected:
    std::uint32_t rest(const Eigen::Vector3d& place)
    {
        addResting(*world, place);
        return static_cast<std::uint32_t>(world->spheres.size() - 1);
    }
    /// Ids that wake, of all, in order.
    std::vector<std::uint32_t> wake(std::uint32_t stays = 1000)
    {
        std::vector<std::uint32_t> all(world->spheres.size());
        std::iota(all.begin(), all.end(), 0U);
        std::vector<std::uint32_t> woken;
        support.wakeUncarried(
            all, [&](std::uint32_t id) { return id != stays; },
            [&](std::uint32_t id)
            {
                world->spheres.wake(id);
                woken.push_back(id);
            });
        return woken;
    }

    std::unique_ptr<World> world = smallWorld(shapes::box({-8, -8, -8}, {8, 8, 8}));
    SupportAtRest support{*world};
};

// A sphere in the hollow of three that touch is sqrt(8/3) above them.
TEST_F(SupportAtRestTest, TheFloorCarriesThreeAndThreeCarryOneTwoDoNot)
{
    const double side = 2 / std::sqrt(3.0);
    const std::uint32_t first = rest({side, -7, 0});
    rest({-side / 2, -7, 1});
    rest({-side / 2, -7, -1});
    const std::uint32_t top = rest({0, -7 + std::sqrt(8.0 / 3), 0});
    for (std::uint32_t id = 0; id < 4; ++id)
    {
        EXPECT_TRUE(support.carries(id)) << id;
    }
    world->spheres.wake(first);
    EXPECT_FALSE(support.carries(top));
}

TEST_F(SupportAtRestTest, WhatHangsInTheAirWakesAndAllThatItCarried)
{
    rest({0, -7, 0});
    rest({4, 0, 0}); // carried by the next until that has woken, and so on
    rest({4, -2, 0});
    rest({4, -4, 0});                              // on nothing
    const std::uint32_t beside = rest({0, -5, 0}); // on the first
    EXPECT_EQ(wake(), (std::vector<std::uint32_t>{3, 2, 1}));
    EXPECT_TRUE(support.carries(beside));
    EXPECT_FALSE(world->spheres.isRunning(beside));
}

TEST_F(SupportAtRestTest, WhatMayNotWakeStaysAndCarriesOthers)
{
    rest({4, -4, 0});
    rest({4, -2, 0});
    EXPECT_EQ(wake(0), std::vector<std::uint32_t>{});
    EXPECT_EQ(wake(1), std::vector<std::uint32_t>{0});
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/world/spheres.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

const Eigen::Vector3d kStill = Eigen::Vector3d::Zero();
const Eigen::Vector3d kFast(1, -2, 3);

TEST(Velocities, AreZeroUntilSetAndAgainAtRest)
{
    Spheres spheres;
    for (int k = 0; k < 600; ++k)
    {
        spheres.add({0, 0, 0}, 1, 0);
    }
    EXPECT_EQ(spheres.velocity(599), kStill);
    spheres.setVelocity(599, kFast);
    spheres.setVelocity(598, -kFast);
    spheres.setState(599, SphereState::frozen);
    EXPECT_EQ(spheres.velocity(599), kStill);
    EXPECT_EQ(spheres.velocity(598), -kFast);
    spheres.setState(599, SphereState::discarded);
    spheres.setState(599, SphereState::running);
    EXPECT_EQ(spheres.velocity(599), kStill);
}

TEST(Velocities, OfOthersStayWhenSomeComeToRestOnTheSamePage)
{
    Spheres spheres;
    for (int k = 0; k < 300; ++k)
    {
        spheres.setVelocity(spheres.add({0, 0, 0}, 1, 0), k * kFast);
    }
    for (int k = 0; k < 300; k += 2)
    {
        spheres.setState(k, SphereState::frozen);
    }
    for (int k = 0; k < 300; ++k)
    {
        EXPECT_EQ(spheres.velocity(k), k % 2 == 0 ? kStill : Eigen::Vector3d(k * kFast)) << k;
    }
}

TEST(Velocities, GoWithASphereThatTakesAnothersPlace)
{
    Spheres spheres;
    spheres.add({0, 0, 0}, 1, 0);
    spheres.setVelocity(spheres.add({5, 0, 0}, 1, 0), kFast);
    spheres.moveTo(1, 0);
    spheres.removeLast();
    ASSERT_EQ(spheres.size(), 1u);
    EXPECT_EQ(spheres.velocity(0), kFast);
    EXPECT_EQ(spheres.position(0), Eigen::Vector3d(5, 0, 0));
    spheres.setState(0, SphereState::frozen);
    EXPECT_EQ(spheres.velocity(0), kStill);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
// Forces and moments that balance spheres with rolling friction, against statics by hand.
#include "simulation/quality/joint_balance.hpp"
#include "unit/simulation/quality/hand_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

TEST(RollingBalance, LetsASphereStandOnASlopeThatRollingFrictionIsEnoughFor)
{
    const double slope = 0.2;
    ContactNetwork network =
        HandNetwork(1.7).add({0, 0, 0}).wall(0, {std::sin(slope), std::cos(slope), 0}).network();
    EXPECT_EQ(leastFrictionOf(network), std::numeric_limits<double>::infinity()) << "it rolls";
    network.rollingFriction = 0.99 * std::tan(slope);
    EXPECT_EQ(leastFrictionOf(network), std::numeric_limits<double>::infinity());
    network.rollingFriction = 1.01 * std::tan(slope);
    EXPECT_NEAR(leastFrictionOf(network), std::tan(slope), 0.01 * std::tan(slope));
}

// The force between them is the weight of the upper one. Its torque is that weight times the radius
// times the sine, and the reduced radius is half of the radius.
TEST(RollingBalance, LetsASphereLeanFromTheTopOfAnotherByHalfOfTheRollingFriction)
{
    const double lean = 0.1;
    ContactNetwork network = HandNetwork()
                                 .add({0, 0, 0})
                                 .add({2 * std::sin(lean), 2 * std::cos(lean), 0})
                                 .touch(1, 0)
                                 .wall(0, {0, 1, 0})
                                 .network();
    network.rollingFriction = 2 * 0.99 * std::tan(lean);
    EXPECT_EQ(leastFrictionOf(network), std::numeric_limits<double>::infinity());
    network.rollingFriction = 2 * 1.01 * std::tan(lean);
    EXPECT_NEAR(leastFrictionOf(network), std::tan(lean), 0.01 * std::tan(lean));
}

// Both bodies of a contact have its moment, one against the other: torques by hand.
TEST(RollingBalance, TurnsNothingWhereMomentsBalanceTorques)
{
    const double lean = 0.1;
    ContactNetwork network = HandNetwork(1.3)
                                 .add({0, 0, 0})
                                 .add({2 * std::sin(lean), 2 * std::cos(lean), 0}, 0.8)
                                 .touch(1, 0)
                                 .wall(0, {0, 1, 0})
                                 .network();
    network.rollingFriction = 0.5;
    Threads threads(1);
    JointBalance forces(network, threads);
    (void)forces.solve(0.5, {.unbalance = kFine});
    std::vector<Vector3d> torques(network.bodies.size(), Vector3d::Zero());
    for (std::size_t k = 0; k < network.contacts.size(); ++k)
    {
        const auto& [normal, upon, from] = network.contacts[k];
        const Vector3d arm = -network.bodies[upon].radius * normal;
        torques[upon] += arm.cross(forces.force(k)) + forces.moment(k);
        if (from != ContactNetwork::kWall)
        {
            const Vector3d other = network.bodies[from].radius * normal;
            torques[from] += other.cross(-forces.force(k)) - forces.moment(k);
        }
    }
    for (const Vector3d& torque : torques)
    {
        EXPECT_LT(torque.norm(), 1e-3);
    }
    EXPECT_GT(forces.moment(0).norm(), 0.05);
}

} // namespace
} // namespace frostfill

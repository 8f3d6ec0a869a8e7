// SPDX-License-Identifier: MIT
// Forces that balance all spheres at once, against statics by hand, and against another method.
#include "simulation/quality/joint_balance.hpp"

#include "base/random.hpp"
#include "oracle/rest.hpp"
#include "oracle/rolling.hpp"
#include "unit/simulation/quality/hand_network.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

double unbalanceOf(const ContactNetwork& network, std::uint32_t body, double friction)
{
    Threads threads(1);
    JointBalance forces(network, threads);
    (void)forces.solve(friction, {.unbalance = kFine});
    return forces.unbalance(body);
}

/// Three spheres between walls, the middle one higher: see oracle::frictionOfArch.
ContactNetwork arch(double rise)
{
    const Vector3d step = 2 * Vector3d(std::cos(rise), std::sin(rise), 0);
    return HandNetwork()
        .add({0, 0, 0})
        .add({-step.x(), -step.y(), 0})
        .add({step.x(), -step.y(), 0})
        .touch(0, 1)
        .touch(0, 2)
        .wall(1, {1, 0, 0})
        .wall(2, {-1, 0, 0})
        .network();
}

TEST(JointBalance, LetsEachContactOfAColumnBearAllThatIsAboveIt)
{
    constexpr std::uint32_t kHeight = 40;
    HandNetwork column;
    for (std::uint32_t k = 0; k < kHeight; ++k)
    {
        column.add({0, 2.0 * k, 0});
        k == 0 ? column.wall(0, {0, 1, 0}) : column.touch(k, k - 1);
    }
    const ContactNetwork network = column.network();
    Threads threads(1);
    JointBalance forces(network, threads);
    const Balance balance = forces.solve(0, {.unbalance = kFine});
    EXPECT_TRUE(balance.settled);
    EXPECT_EQ(balance.unbalanced, 0U);
    for (std::uint32_t k = 0; k < kHeight; ++k)
    {
        EXPECT_NEAR(forces.force(k).y(), kHeight - k, 0.01) << k;
    }
}

TEST(JointBalance, LetsAPyramidSpreadWithoutFrictionAsFastAsItDoes)
{
    const ContactNetwork two = HandNetwork().pyramid(2).network();
    EXPECT_NEAR(unbalanceOf(two, 2, 0), oracle::sinkingBetweenTwo(), 1e-3);
    // What lies below moves aside along the line of centres, which is at 30 degrees.
    EXPECT_NEAR(unbalanceOf(two, 0, 0), oracle::sinkingBetweenTwo() * std::sqrt(3.0), 1e-3);
}

TEST(JointBalance, LetsASphereRollDownAPlane)
{
    for (const double angle : {0.1, 0.5, 1.0})
    {
        const ContactNetwork network =
            HandNetwork().add({0, 0, 0}).wall(0, {std::sin(angle), std::cos(angle), 0}).network();
        EXPECT_NEAR(unbalanceOf(network, 0, 5), oracle::rollingDown(angle), 1e-3) << angle;
        EXPECT_NEAR(unbalanceOf(network, 0, 0), std::sin(angle), 1e-3) << angle;
        EXPECT_EQ(leastFrictionOf(network), std::numeric_limits<double>::infinity());
    }
}

TEST(JointBalance, HoldsASphereBetweenWallsThatFaceEachOtherByFrictionOnly)
{
    const ContactNetwork network =
        HandNetwork().add({0, 0, 0}).wall(0, {1, 0, 0}).wall(0, {-1, 0, 0}).network();
    EXPECT_NEAR(unbalanceOf(network, 0, 0), 1, 1e-12);
    EXPECT_LT(unbalanceOf(network, 0, 0.5), kFine);
}

TEST(JointBalance, FindsTheFrictionFromWhichAPyramidStands)
{
    for (const int below : {2, 3})
    {
        const double expected = oracle::frictionOfPyramid(below);
        EXPECT_NEAR(leastFrictionOf(HandNetwork().pyramid(below).network()), expected,
                    0.01 * expected)
            << below;
    }
}

TEST(JointBalance, FindsTheFrictionFromWhichAnArchStands)
{
    for (const double rise : {0.2, 0.4, 0.7})
    {
        const double expected = oracle::frictionOfArch(rise);
        EXPECT_NEAR(leastFrictionOf(arch(rise)), expected, 0.01 * expected) << rise;
    }
}

TEST(JointBalance, DoesNotDependOnSizes)
{
    for (const double radius : {0.01, 0.3})
    {
        const double expected = oracle::frictionOfPyramid(3);
        EXPECT_NEAR(leastFrictionOf(HandNetwork(radius).pyramid(3).network()), expected,
                    0.01 * expected)
            << radius;
    }
}

TEST(JointBalance, FindsNothingToHoldASphereThatTouchesNothing)
{
    const ContactNetwork network =
        HandNetwork().add({0, 0, 0}).add({9, 0, 0}).wall(1, {0, 1, 0}).network();
    EXPECT_EQ(unbalanceOf(network, 0, 1), 1);
    EXPECT_EQ(leastFrictionOf(network), std::numeric_limits<double>::infinity());
    EXPECT_EQ(leastFrictionOf(network, 1), 0) << "one may be unbalanced";
}

TEST(JointBalance, IsContentWithNoSpheres)
{
    const ContactNetwork network;
    Threads threads(1);
    JointBalance forces(network, threads);
    EXPECT_EQ(forces.solve(0.3, {.unbalance = kFine}).unbalanced, 0U);
    EXPECT_EQ(leastFrictionOf(network), 0);
}

// Walls bear the thrust. What lies in a hollow of four still lies on two opposite ones when one is
// gone. When a row is gone, those above it lean on one another; at a wall there is nobody to lean
// on.
TEST(JointBalance, HoldsAFullBoxWithoutFrictionUntilARowAtTheWallIsGone)
{
    constexpr int kAlong = 5;
    EXPECT_EQ(leastFrictionOf(HandNetwork().box(kAlong).network()), 0);
    EXPECT_EQ(leastFrictionOf(HandNetwork().box(kAlong, 6, 1).network()), 0);
    EXPECT_EQ(leastFrictionOf(HandNetwork().box(kAlong, kAlong, kAlong).network()), 0);
    const double least = leastFrictionOf(HandNetwork().box(kAlong, 0, kAlong).network());
    EXPECT_GT(least, 0.02);
    EXPECT_LT(least, 1);
}

/// The least that pushes along these directions leave of a load, by brute force: of every set of
/// directions the best pushes, if none of them pulls.
double leastRest(const Eigen::MatrixXd& directions, const Eigen::VectorXd& load)
{
    double least = load.norm();
    const int count = static_cast<int>(directions.cols());
    for (int set = 1; set < 1 << count; ++set)
    {
        Eigen::MatrixXd some(directions.rows(), 0);
        for (int k = 0; k < count; ++k)
        {
            if ((set >> k & 1) != 0)
            {
                some.conservativeResize(Eigen::NoChange, some.cols() + 1);
                some.rightCols(1) = directions.col(k);
            }
        }
        const Eigen::VectorXd push = some.completeOrthogonalDecomposition().solve(-load);
        if (push.minCoeff() >= -1e-12)
        {
            least = std::min(least, (load + some * push).norm());
        }
    }
    return least;
}

/// Three bodies of different sizes with nine contacts in any directions.
ContactNetwork randomNetwork(std::uint64_t trial)
{
    const auto draw = [&](std::uint64_t n) { return uniformRandom(11, trial, n); };
    constexpr std::uint32_t kBodies = 3;
    HandNetwork random;
    for (std::uint32_t body = 0; body < kBodies; ++body)
    {
        random.add(Vector3d(body, 0, 0), 0.5 + draw(body));
    }
    for (std::uint64_t n = 10; n < 100; n += 10)
    {
        const Vector3d normal =
            Vector3d(draw(n) - 0.5, draw(n + 1) - 0.4, draw(n + 2) - 0.5).normalized();
        const auto upon = static_cast<std::uint32_t>(kBodies * draw(n + 3));
        const auto from = static_cast<std::uint32_t>(kBodies * draw(n + 4));
        upon == from ? random.wall(upon, normal) : random.push(upon, from, normal);
    }
    return random.network();
}

TEST(JointBalance, LeavesAsLittleAsTheBestOfAllSetsOfContactsLeaves)
{
    for (std::uint64_t trial = 0; trial < 60; ++trial)
    {
        const ContactNetwork network = randomNetwork(trial);
        const auto bodies = static_cast<Eigen::Index>(network.bodies.size());
        const auto contacts = static_cast<Eigen::Index>(network.contacts.size());
        const auto rowOf = [](std::uint32_t body) { return 3 * Eigen::Index{body}; };
        // In accelerations times square roots of masses.
        const auto rootOf = [&](std::uint32_t body)
        { return std::pow(network.bodies[body].radius, 1.5); };
        Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(3 * bodies, contacts);
        for (Eigen::Index k = 0; k < contacts; ++k)
        {
            const auto& [normal, upon, from] = network.contacts[static_cast<std::size_t>(k)];
            directions.block<3, 1>(rowOf(upon), k) += normal / rootOf(upon);
            if (from != ContactNetwork::kWall)
            {
                directions.block<3, 1>(rowOf(from), k) -= normal / rootOf(from);
            }
        }
        Threads threads(1);
        JointBalance forces(network, threads);
        (void)forces.solve(0, {.unbalance = 1e-6});
        Eigen::VectorXd load(3 * bodies);
        Eigen::VectorXd left(bodies);
        for (std::uint32_t body = 0; body < network.bodies.size(); ++body)
        {
            load.segment<3>(rowOf(body)) = rootOf(body) * network.bodies[body].pull;
            left[body] = rootOf(body) * forces.unbalance(body);
        }
        EXPECT_NEAR(left.norm(), leastRest(directions, load), 1e-4) << trial;
    }
}

TEST(JointBalance, KeepsForcesWithinTheConesOfFriction)
{
    const ContactNetwork network = arch(0.4);
    Threads threads(1);
    JointBalance forces(network, threads);
    for (const double friction : {0.0, 0.1, 0.5})
    {
        (void)forces.solve(friction, {.unbalance = kFine});
        for (std::size_t k = 0; k < network.contacts.size(); ++k)
        {
            const double along = forces.force(k).dot(network.contacts[k].normal);
            const double across = (forces.force(k) - along * network.contacts[k].normal).norm();
            EXPECT_GE(along, 0);
            EXPECT_LE(across, friction * along + 1e-12) << friction;
        }
    }
}

TEST(JointBalance, FindsTheSameBitsOnAnyNumberOfThreads)
{
    const ContactNetwork network = HandNetwork().box(14, 30, 5).network();
    ASSERT_GT(network.contacts.size(), 4000U);
    const auto solve = [&](int count)
    {
        Threads threads(count);
        JointBalance forces(network, threads);
        (void)forces.solve(0.05, {.unbalance = 0.1});
        std::vector<double> missing;
        for (std::uint32_t body = 0; body < network.bodies.size(); ++body)
        {
            missing.push_back(forces.unbalance(body));
        }
        return missing;
    };
    const std::vector<double> one = solve(1);
    EXPECT_EQ(solve(2), one);
    EXPECT_EQ(solve(5), one);
}

} // namespace
} // namespace frostfill

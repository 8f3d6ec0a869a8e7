// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "simulation/contact/contact.hpp"
#include "simulation/quality/equilibrium.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace frostfill
{
namespace
{

using Normals = std::vector<Eigen::Vector3d>;

/// Share of its weight that contacts cannot carry: 0 when supported, 1 in free fall.
double unsupportedWeight(const Normals& normals)
{
    return projectToFree({0, -1, 0}, normals).norm();
}

TEST(Support, SphereWithoutContactsCarriesNothing)
{
    EXPECT_EQ(unsupportedWeight(Normals{}), 1);
}

TEST(Support, FloorCarriesEverything)
{
    EXPECT_NEAR(unsupportedWeight(Normals{{0, 1, 0}}), 0, 1e-15);
}

TEST(Support, CeilingCarriesNothing)
{
    EXPECT_EQ(unsupportedWeight(Normals{{0, -1, 0}}), 1);
}

TEST(Support, InclineLeavesTheSineOfItsAngle)
{
    const double angle = 0.3;
    EXPECT_NEAR(unsupportedWeight(Normals{{std::sin(angle), std::cos(angle), 0}}), std::sin(angle),
                1e-15);
}

TEST(Support, GrooveCarriesEverything)
{
    EXPECT_NEAR(unsupportedWeight(Normals{{0.6, 0.8, 0}, {-0.6, 0.8, 0}}), 0, 1e-15);
}

TEST(Support, GrooveThatDescendsLeavesItsSlope)
{
    // Walls at 45 degrees of a groove whose bottom falls along x by the angle a.
    const double a = 0.2;
    const double c = std::sqrt(0.5);
    const Normals normals = {{c * std::sin(a), c * std::cos(a), c},
                             {c * std::sin(a), c * std::cos(a), -c}};
    EXPECT_NEAR(unsupportedWeight(normals), std::sin(a), 1e-14);
}

TEST(Support, ThreeSpheresBelowCarryEverything)
{
    const double h = std::sqrt(2.0 / 3.0);
    const double s = 1 / std::sqrt(3.0);
    Normals normals;
    for (int k = 0; k < 3; ++k)
    {
        const double a = 2 * 3.14159265358979 * k / 3;
        normals.emplace_back(s * std::cos(a), h, s * std::sin(a));
    }
    EXPECT_EQ(unsupportedWeight(normals), 0);
}

TEST(Support, AgreesWithProjectedGradientsOnRandomContacts)
{
    int uncarried = 0;
    for (std::uint64_t trial = 0; trial < 200; ++trial)
    {
        Normals normals;
        const auto count = 1 + mixBits(trial) % 6;
        for (std::uint64_t k = 0; k < count; ++k)
        {
            const auto random = [&](std::uint64_t d)
            { return 2 * uniformRandom(3, trial, 3 * k + d) - 1; };
            normals.push_back(Eigen::Vector3d(random(0), random(1), random(2)).normalized());
        }
        // Oracle: minimise |up - sum lambda n| over lambda >= 0 by coordinate descent.
        std::vector<double> lambda(count, 0);
        Eigen::Vector3d rest = Eigen::Vector3d::UnitY();
        for (int sweep = 0; sweep < 20000; ++sweep)
        {
            for (std::size_t k = 0; k < count; ++k)
            {
                const double better = std::max(0.0, lambda[k] + rest.dot(normals[k]));
                rest -= (better - lambda[k]) * normals[k];
                lambda[k] = better;
            }
        }
        EXPECT_NEAR(unsupportedWeight(normals), rest.norm(), 1e-3) << "trial " << trial;
        // The judge answers the same question in another way.
        const Eigen::Vector3d down(0, -1, 0);
        EXPECT_TRUE(contactsCanCarry(down, normals, rest.norm() + 2e-3)) << "trial " << trial;
        if (rest.norm() > 2e-3)
        {
            EXPECT_FALSE(contactsCanCarry(down, normals, rest.norm() - 2e-3)) << "trial " << trial;
            ++uncarried;
        }
    }
    EXPECT_GT(uncarried, 50);
}

// Two steep contacts, each so far from level: normal and friction forces of both add up to the
// weight, without a torque, if the friction is above the tangent of half of what they lack.
TEST(Support, FrictionCarriesBetweenTwoFacesThatDivergeUpToItsAngle)
{
    const Eigen::Vector3d down(0, -1, 0);
    for (const double opening : {0.1, 0.3})
    {
        // The faces lean out: their normals lead a little down.
        const Normals faces = {{std::cos(opening), -std::sin(opening), 0},
                               {-std::cos(opening), -std::sin(opening), 0}};
        EXPECT_FALSE(contactsCanCarry(down, faces, 0.1));
        EXPECT_TRUE(frictionCanCarry(down, faces, 1.1 * std::tan(opening), 0.01)) << opening;
        EXPECT_FALSE(frictionCanCarry(down, faces, 0.9 * std::tan(opening), 0.01)) << opening;
    }
    EXPECT_FALSE(frictionCanCarry(down, Normals{{0.6, 0.8, 0}}, 5, 0.1)) << "it rolls";
}

// On a slope; and on a sphere, whose reduced radius with it is less than its own.
TEST(Support, RollingFrictionCarriesOnASlopeUpToItsTangentAndLessOnASphere)
{
    const Eigen::Vector3d down(0, -1, 0);
    const double slope = 0.3;
    const double radius = 0.4;
    const double other = 1.2;
    const Normals face = {{std::sin(slope), std::cos(slope), 0}};
    const auto carries = [&](double rolling, double allowed, std::span<const double> below) {
        return frictionCanCarry(down, face, 1, allowed, {rolling, radius, below});
    };
    EXPECT_TRUE(carries(1.03 * std::tan(slope), 0.01, {}));
    EXPECT_FALSE(carries(0.97 * std::tan(slope), 0.001, {}));
    const double share = other / (radius + other);
    const std::array below = {other};
    EXPECT_TRUE(carries(1.03 * std::tan(slope) / share, 0.01, below));
    EXPECT_FALSE(carries(0.97 * std::tan(slope) / share, 0.001, below));
}

} // namespace
} // namespace frostfill

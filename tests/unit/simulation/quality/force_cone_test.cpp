// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "simulation/quality/joint_balance.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

Vector3d randomVector(std::uint64_t stream, std::uint64_t number)
{
    const auto random = [&](std::uint64_t n) { return 2 * uniformRandom(stream, number, n) - 1; };
    return {random(0), random(1), random(2)};
}

/// Any load in the cone.
ContactLoad insideCone(std::uint64_t number, const Vector3d& normal, const ConeSlopes& slopes)
{
    const double along = 2 * uniformRandom(7, number, 0);
    const Vector3d sideways = normal.cross(randomVector(8, number)).normalized();
    const Vector3d about = normal.cross(randomVector(9, number)).normalized();
    return {along * (normal + uniformRandom(7, number, 1) * slopes.friction * sideways),
            along * uniformRandom(7, number, 2) * slopes.rolling * about};
}

// A point of a convex set is the nearest to another if every point of the set lies, seen from it,
// on the side away from the other one.
TEST(ForceCone, HasNoPointNearerThanTheProjection)
{
    const ConeSlopes all[] = {{0.3, 0.1}, {0.3, 0}, {0, 0}, {2, 0.05}, {0.1, 0.9}, {0, 0.4}};
    for (const ConeSlopes& slopes : all)
    {
        for (std::uint64_t k = 0; k < 200; ++k)
        {
            const Vector3d normal = randomVector(1, k).normalized();
            const ContactLoad load = {randomVector(2, k) + 0.3 * normal, randomVector(3, k)};
            const ContactLoad nearest = projectToCone(load, normal, slopes);
            const double along = nearest.force.dot(normal);
            EXPECT_GE(along, 0);
            EXPECT_LE((nearest.force - along * normal).norm(), slopes.friction * along + 1e-12);
            EXPECT_LE(nearest.roll.norm(), slopes.rolling * along + 1e-12);
            EXPECT_NEAR(nearest.roll.dot(normal), 0, 1e-12);
            for (std::uint64_t n = 0; n < 200; ++n)
            {
                const ContactLoad other = insideCone(n, normal, slopes);
                const double beyond =
                    (load.force - nearest.force).dot(other.force - nearest.force) +
                    (load.roll - nearest.roll).dot(other.roll - nearest.roll);
                ASSERT_LE(beyond, 1e-12) << k << ", " << n;
            }
        }
    }
}

TEST(ForceCone, IsThatOfForcesAloneWithoutRollingFriction)
{
    for (std::uint64_t k = 0; k < 200; ++k)
    {
        const Vector3d normal = randomVector(1, k).normalized();
        const Vector3d force = randomVector(2, k);
        const ContactLoad load = projectToCone({force, randomVector(3, k)}, normal, {0.3, 0});
        EXPECT_LT((load.force - projectToCone(force, normal, 0.3)).norm(), 1e-14);
        EXPECT_TRUE(load.roll.isZero(0));
    }
}

} // namespace
} // namespace frostfill

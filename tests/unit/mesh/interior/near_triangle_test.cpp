// SPDX-License-Identifier: MIT
#include "mesh/interior/near_triangle.hpp"

#include "support/random_points.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace frostfill
{
namespace
{

/// Triangles square to the axes, and others: of a box, and of a long thin torus.
std::vector<Surface> surfaces()
{
    std::vector<Surface> all;
    all.emplace_back(shapes::box({-1, -1, -1}, {1, 1, 1}, 2));
    all.emplace_back(shapes::torus(1, 0.4, 7, 20));
    return all;
}

double distanceTo(const Surface& surface, std::uint32_t triangle, const Eigen::Vector3d& p)
{
    const auto& [a, b, c] = surface[triangle].corner;
    return (closestPointOnTriangle(p, a, b, c).point - p).norm();
}

TEST(NearTriangle, HasWhatIsAsNearAsTheNearestPointIs)
{
    RandomPoints random(5);
    std::size_t within = 0;
    for (const Surface& surface : surfaces())
    {
        for (int k = 0; k < 100; ++k)
        {
            const Eigen::Vector3d p(random.uniform(-3, 3), random.uniform(-3, 3),
                                    random.uniform(-3, 3));
            for (std::uint32_t t = 0; t < surface.size(); ++t)
            {
                const double distance = distanceTo(surface, t, p);
                for (const double reach :
                     {0.3, 1.5, distance * (1 - 1e-12), distance * (1 + 1e-12)})
                {
                    ASSERT_EQ(NearTriangle(surface, t, reach).contains(p), distance <= reach)
                        << k << ' ' << t;
                    within += distance <= reach ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(within, 1000u);
}

TEST(NearTriangle, LeavesNothingOutOfALineAndHasNothingTooMuch)
{
    RandomPoints random(5);
    std::size_t within = 0;
    std::size_t sure = 0;
    for (const Surface& surface : surfaces())
    {
        for (int line = 0; line < 200; ++line)
        {
            const double y = random.uniform(-3, 3);
            const double z = random.uniform(-3, 3);
            const auto t =
                static_cast<std::uint32_t>(line) % static_cast<std::uint32_t>(surface.size());
            const double reach = line % 2 == 0 ? 0.4 : 1.8;
            const NearTriangle near(surface, t, reach);
            const NearTriangle::Chord plane = near.nearPlane(y, z);
            const NearTriangle::Chord surely = near.surelyNear(y, z);
            for (double x = -3; x < 3; x += 0.01)
            {
                const bool isNear = distanceTo(surface, t, {x, y, z}) <= reach;
                const bool isSure = x >= surely.from && x <= surely.to;
                ASSERT_TRUE(!isNear || (x >= plane.from && x <= plane.to)) << line << ' ' << x;
                ASSERT_TRUE(isNear || !isSure) << line << ' ' << x;
                within += isNear ? 1 : 0;
                sure += isSure ? 1 : 0;
            }
        }
    }
    EXPECT_GT(within, 5000u);
    EXPECT_GT(sure, within / 2); // or it would be no help
}

TEST(NearTriangle, IsNearNothingWithoutAReach)
{
    const Surface surface(shapes::box({-1, -1, -1}, {1, 1, 1}, 1));
    const NearTriangle near(surface, 0, -0.1);
    const auto& [a, b, c] = surface[0].corner;
    const Eigen::Vector3d onIt = (a + 2 * b + 4 * c) / 7;
    EXPECT_FALSE(near.contains(onIt));
    const NearTriangle::Chord surely = near.surelyNear(onIt.y(), onIt.z());
    EXPECT_GT(surely.from, surely.to);
}

} // namespace
} // namespace frostfill

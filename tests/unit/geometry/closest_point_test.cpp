// SPDX-License-Identifier: MIT
#include "geometry/closest_point.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace frostfill
{
namespace
{

const Eigen::Vector3d kA(0, 0, 0);
const Eigen::Vector3d kB(2, 0, 0);
const Eigen::Vector3d kC(0, 0, 1);

TEST(ClosestPoint, NamesTheFeatureThatIsClosest)
{
    const auto feature = [](double x, double y, double z) {
        return closestPointOnTriangle({x, y, z}, kA, kB, kC).feature;
    };
    EXPECT_EQ(feature(0.5, 3, 0.25), TriangleFeature::face);
    EXPECT_EQ(feature(-1, 1, -1), TriangleFeature::corner0);
    EXPECT_EQ(feature(4, 1, -1), TriangleFeature::corner1);
    EXPECT_EQ(feature(-1, 1, 4), TriangleFeature::corner2);
    EXPECT_EQ(feature(1, 1, -1), TriangleFeature::edge0);
    EXPECT_EQ(feature(2, 1, 2), TriangleFeature::edge1);
    EXPECT_EQ(feature(-1, 1, 0.5), TriangleFeature::edge2);
}

TEST(ClosestPoint, IsNeverFartherThanAnyPointOfTheTriangle)
{
    for (std::uint64_t trial = 0; trial < 500; ++trial)
    {
        std::uint64_t draw = 0;
        const auto random = [&] { return 4 * uniformRandom(7, trial, draw++) - 2; };
        const Eigen::Vector3d p(random(), random(), random());
        const Eigen::Vector3d a(random(), random(), random());
        const Eigen::Vector3d b(random(), random(), random());
        const Eigen::Vector3d c(random(), random(), random());
        const double distance = (p - closestPointOnTriangle(p, a, b, c).point).norm();
        double sampled = std::numeric_limits<double>::infinity();
        constexpr int kSteps = 40;
        for (int u = 0; u <= kSteps; ++u)
        {
            for (int v = 0; u + v <= kSteps; ++v)
            {
                const Eigen::Vector3d q =
                    a + (b - a) * (1.0 * u / kSteps) + (c - a) * (1.0 * v / kSteps);
                sampled = std::min(sampled, (p - q).norm());
            }
        }
        EXPECT_LE(distance, sampled + 1e-12) << "trial " << trial;
        EXPECT_GE(distance, sampled - 0.15) << "trial " << trial;
    }
}

} // namespace
} // namespace frostfill

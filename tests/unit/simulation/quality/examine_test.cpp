// SPDX-License-Identifier: MIT
// The judge is judged: packings placed by hand, on either side of each of its thresholds.

#include "base/random.hpp"
#include "support/expect_error.hpp"
#include "support/small_world.hpp"
#include "unit/simulation/quality/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

TEST(Examine, FindsNothingWrongWithAPackingThatHasNoFaults)
{
    const QualityReport report =
        HandPacking().add({0, -9, 0}).add({3, -9, 0}).addRunning({0, 4, 0}).in(room());
    EXPECT_EQ(report.maxOverlap, 0);
    EXPECT_EQ(report.meanOverlap, 0);
    EXPECT_LT(report.maxWallOverlap, 1e-15);
    EXPECT_EQ(report.unsupported, 0u);
    EXPECT_EQ(report.centresOutside, 0u);
    EXPECT_EQ(report.notFinite, 0u);
}

TEST(Examine, MeasuresTheLargestAndTheMeanOverlap)
{
    HandPacking packing;
    packing.add({0, 0, 0}).add({1.75, 0, 0});            // a quarter of a radius
    packing.addRunning({0, 0, 6}).add({0, 1.95, 6});     // a twentieth
    packing.add({-6, 0, 0}).add({-6, 0, 2.1});           // apart: no pair
    packing.addRunning({6, 6, 6}).addRunning({8, 6, 6}); // just touching: a pair with nothing
    const QualityReport report = packing.in(room());
    EXPECT_NEAR(report.maxOverlap, 0.25, 1e-14);
    EXPECT_NEAR(report.meanOverlap, 0.30 / 3, 1e-14);
}

TEST(Examine, MeasuresOverlapsInTheSmallerRadius)
{
    for (const double scale : {1e-3, 1.0, 40.0})
    {
        const TriangleMesh mesh =
            shapes::box(scale * Vector3d(-10, -10, -10), scale * Vector3d(10, 10, 10), 4);
        const QualityReport report = HandPacking()
                                         .add(scale * Vector3d(1, 2, 3), 0.5 * scale)
                                         .add(scale * Vector3d(3.4, 2, 3), 2 * scale)
                                         .in(mesh);
        EXPECT_NEAR(report.maxOverlap, 0.2, 1e-12) << scale;
    }
}

// A pile of 1:20, half of its mass in the smallest.
TEST(Examine, LooksAtFewSpheresBesideEachWhateverTheirSizes)
{
    std::vector<Vector3d> centres;
    std::vector<double> radii;
    std::uint64_t draw = 0;
    const auto random = [&] { return uniformRandom(3, 0, draw++); };
    for (const double radius : {1.0, 0.2, 0.05})
    {
        // The mass of each size takes a fifth of the room below y = -6.
        const double each = 4.0 / 3.0 * 3.14159 * radius * radius * radius;
        for (double k = 0; k < 20 * 20 * 4 / 5.0 / each; ++k)
        {
            centres.emplace_back(20 * random() - 10, -10 + 4 * random(), 20 * random() - 10);
            radii.push_back(radius);
        }
    }
    const auto world = smallWorld(room());
    place(*world, centres, radii, std::vector<bool>(centres.size(), true));
    const SphereGrid& resting = world->spheres.resting();
    std::size_t candidates = 0;
    for (std::uint32_t row = 0; row < resting.size(); row += 100)
    {
        resting.forEachNear(resting[row].position(), resting[row].radius + 1.01,
                            [&](std::uint32_t) { ++candidates; });
    }
    const double each = 100.0 * static_cast<double>(candidates) / static_cast<double>(radii.size());
    EXPECT_GT(radii.size(), 500'000U);
    EXPECT_LT(each, 200) << "beside a sphere";
}

TEST(Examine, MeasuresSpheresInOnePlaceAsTwoRadii)
{
    EXPECT_EQ(HandPacking().add({1, 1, 1}).add({1, 1, 1}).in(room()).maxOverlap, 2);
}

TEST(Examine, MeasuresHowDeepASphereIsInAWall)
{
    EXPECT_NEAR(HandPacking().addRunning({0, 0, 9.8}, 1).in(room()).maxWallOverlap, 0.8, 1e-14);
    EXPECT_NEAR(HandPacking().addRunning({0, 9.25, 3}, 1).in(room()).maxWallOverlap, 0.25, 1e-14);
    EXPECT_NEAR(HandPacking().addRunning({-9.7, 0, 3}, 0.5).in(room()).maxWallOverlap, 0.4, 1e-14);
    EXPECT_EQ(HandPacking().addRunning({0, 0, 8.9}, 1).in(room()).maxWallOverlap, 0);
}

TEST(Examine, MeasuresACentreOnTheWallAsOneRadius)
{
    // In a face, on an edge, at a corner of four faces, and at one of the room.
    for (const Vector3d& place : {Vector3d(0.3, -10, 0.2), Vector3d(1.7, -10, 3.1),
                                  Vector3d(0, -10, 2.2), Vector3d(0, -10, 0), Vector3d(10, 10, 10)})
    {
        EXPECT_NEAR(HandPacking().addRunning(place).in(room()).maxWallOverlap, 1, 1e-12)
            << place.transpose();
    }
}

// An edge that points into the object is nearer than either of its faces.
TEST(Examine, MeasuresDepthsAtAnEdgeThatPointsInwards)
{
    TriangleMesh mesh = room();
    const TriangleMesh pillar = shapes::box({-10, -10, -10}, {0, 0, 10}, 2);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), pillar.vertices.begin(), pillar.vertices.end());
    for (const auto& t : pillar.triangles) // wound the other way: a cavity that fills a corner
    {
        mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
    }
    const QualityReport report = HandPacking().addRunning({0.3, 0.4, 0.1}).in(mesh);
    EXPECT_NEAR(report.maxWallOverlap, 0.5, 1e-14);
    EXPECT_EQ(report.centresOutside, 0u);
}

TEST(Examine, CountsNoneSomeOrAllThatNothingCarries)
{
    HandPacking packing;
    packing.add({0, -9, 0}).add({0, -7, 0}).add({5, -9, 5});
    EXPECT_EQ(packing.in(room()).unsupported, 0u);
    packing.add({5, 0, 5}).add({-5, 0, 5});
    EXPECT_EQ(packing.in(room()).unsupported, 2u);
    EXPECT_EQ(HandPacking().add({5, 0, 5}).add({-5, 9, 5}).in(room()).unsupported, 2u);
}

TEST(Examine, AsksOnlySpheresAtRestForSupportAndOnlyThoseCarry)
{
    EXPECT_EQ(HandPacking().addRunning({5, 0, 5}).in(room()).unsupported, 0u);
    EXPECT_EQ(HandPacking().addRunning({0, -9, 0}).add({0, -7, 0}).in(room()).unsupported, 1u);
}

TEST(Examine, TakesACeilingAndASphereAboveForNoSupport)
{
    EXPECT_EQ(HandPacking().add({0, 9, 0}).in(room()).unsupported, 1u);
    EXPECT_EQ(HandPacking().add({0, 0, 0}).addRunning({0, 2, 0}).in(room()).unsupported, 1u);
}

// A gap counts as a contact up to a hundredth of the sphere's own radius.
TEST(Examine, TakesAGapForAContactUpToAHundredthOfTheRadius)
{
    for (const double radius : {1.0, 0.25})
    {
        for (const auto& [gap, unsupported] : {std::pair(0.0099, 0u), {0.0101, 1u}})
        {
            const double height = radius * (1 + gap);
            HandPacking onFloor;
            onFloor.add({0, -10 + height, 0}, radius).addRunning({5, 5, 5});
            EXPECT_EQ(onFloor.in(room()).unsupported, unsupported) << radius << " " << gap;
            HandPacking onSphere;
            onSphere.add({0, -9, 0}).add({0, -8 + height, 0}, radius);
            EXPECT_EQ(onSphere.in(room()).unsupported, unsupported) << radius << " " << gap;
        }
    }
}

// On one sphere the share that remains is the sine of the angle from the vertical.
TEST(Examine, LetsATenthOfTheWeightRemain)
{
    for (const auto& [share, unsupported] : {std::pair(0.099, 0u), {0.101, 1u}})
    {
        const Vector3d normal(share, std::sqrt(1 - share * share), 0);
        HandPacking packing;
        packing.add({0, -9, 0}).add(Vector3d(0, -9, 0) + 2 * normal);
        EXPECT_EQ(packing.in(room()).unsupported, unsupported) << share;
    }
}

TEST(Examine, KnowsThatTwoAndThreeContactsCarryTogether)
{
    HandPacking groove; // along the edge of floor and wall: each alone would not do, at 45 degrees
    const double c = std::sqrt(2.0);
    groove.add({-c, -9, 0}).add({c, -9, 0}).add({0, -9 + c, 0});
    EXPECT_EQ(groove.in(room()).unsupported, 0u);
    HandPacking three;
    for (int k = 0; k < 3; ++k)
    {
        const double a = 2 * M_PI * k / 3;
        three.add({2 / std::sqrt(3.0) * std::cos(a), -9, 2 / std::sqrt(3.0) * std::sin(a)});
    }
    three.add({0, -9 + 2 * std::sqrt(2.0 / 3.0), 0});
    EXPECT_EQ(three.in(room()).unsupported, 0u);
}

TEST(Examine, PullsAgainstTheAxisThatIsUp)
{
    const HandPacking onZ = HandPacking().add({0, 0, -9});
    EXPECT_EQ(onZ.in(room(), Axis::z).unsupported, 0u);
    EXPECT_EQ(onZ.in(room(), Axis::y).unsupported, 1u);
    EXPECT_EQ(HandPacking().add({-9, 0, 0}).in(room(), Axis::x).unsupported, 0u);
}

TEST(Examine, CountsPositionsThatAreNotNumbersAndJudgesTheRest)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    HandPacking packing;
    packing.add({nan, 0, 0}).add({0, infinity, 0}).addRunning({0, nan, nan});
    packing.add({0, 0, 0}).add({1.5, 0, 0});
    const QualityReport report = packing.in(room());
    EXPECT_EQ(report.notFinite, 3u);
    EXPECT_EQ(report.centresOutside, 0u);
    EXPECT_EQ(report.unsupported, 2u);
    EXPECT_NEAR(report.maxOverlap, 0.5, 1e-14);
}

TEST(Examine, RefusesArraysThatDoNotGoTogetherAndRadiiThatAreNone)
{
    const std::vector<Vector3d> two(2, Vector3d::Zero());
    const std::vector<double> one = {1};
    test::expectError(
        ErrorCode::badData,
        [&] {
            (void)examine(room(), two, one, {true, true});
        },
        "2 centres");
    for (const double wrong : {0.0, -1.0, std::nan("")})
    {
        const std::vector<double> radii = {1, wrong};
        test::expectError(
            ErrorCode::badData,
            [&] {
                (void)examine(room(), two, radii, {true, true});
            },
            "sphere 1");
    }
}

} // namespace
} // namespace frostfill

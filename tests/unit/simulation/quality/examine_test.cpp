// SPDX-License-Identifier: MIT
// The judge is judged: packings placed by hand, whose faults are known.

#include "base/random.hpp"
#include "simulation/quality/quality.hpp"
#include "support/expect_error.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

/// Spheres of a packing, at rest unless they are said to run.
class Packing
{
public:
    Packing& add(const Vector3d& centre, double radius = 1, bool atRest = true)
    {
        centres_.push_back(centre);
        radii_.push_back(radius);
        atRest_.push_back(atRest);
        return *this;
    }
    Packing& addRunning(const Vector3d& centre, double radius = 1)
    {
        return add(centre, radius, false);
    }
    [[nodiscard]] QualityReport in(const TriangleMesh& mesh, Axis up = Axis::y) const
    {
        return examine(mesh, centres_, radii_, atRest_, up);
    }

private:
    std::vector<Vector3d> centres_;
    std::vector<double> radii_;
    std::vector<bool> atRest_;
};

/// Twenty across, the floor at y = -10.
TriangleMesh room()
{
    return shapes::box({-10, -10, -10}, {10, 10, 10}, 4);
}

TEST(Examine, FindsNothingWrongWithAPackingThatHasNoFaults)
{
    const QualityReport report =
        Packing().add({0, -9, 0}).add({3, -9, 0}).addRunning({0, 4, 0}).in(room());
    EXPECT_EQ(report.maxOverlap, 0);
    EXPECT_EQ(report.meanOverlap, 0);
    EXPECT_LT(report.maxWallOverlap, 1e-15);
    EXPECT_EQ(report.unsupported, 0u);
    EXPECT_EQ(report.centresOutside, 0u);
    EXPECT_EQ(report.notFinite, 0u);
}

TEST(Examine, MeasuresTheLargestAndTheMeanOverlap)
{
    Packing packing;
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
        const QualityReport report = Packing()
                                         .add(scale * Vector3d(1, 2, 3), 0.5 * scale)
                                         .add(scale * Vector3d(3.4, 2, 3), 2 * scale)
                                         .in(mesh);
        EXPECT_NEAR(report.maxOverlap, 0.2, 1e-12) << scale;
    }
}

TEST(Examine, MeasuresSpheresInOnePlaceAsTwoRadii)
{
    EXPECT_EQ(Packing().add({1, 1, 1}).add({1, 1, 1}).in(room()).maxOverlap, 2);
}

// The oracle is every pair.
TEST(Examine, AgreesWithAllPairsOnRandomSpheres)
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
        Packing packing;
        std::vector<PlacedSphere> spheres;
        for (std::uint64_t k = 0; k < 200; ++k)
        {
            const auto draw = [&](std::uint64_t n) { return uniformRandom(seed, k, n); };
            const Vector3d p = 18 * Vector3d(draw(0) - 0.5, draw(1) - 0.5, draw(2) - 0.5);
            spheres.push_back({p, 0.2 + 0.8 * draw(3)});
            packing.add(p, spheres.back().radius, draw(4) < 0.7);
        }
        double largest = 0;
        double sum = 0;
        int pairs = 0;
        for (std::size_t i = 0; i < spheres.size(); ++i)
        {
            for (std::size_t j = 0; j < i; ++j)
            {
                const PlacedSphere& a = spheres[i];
                const PlacedSphere& b = spheres[j];
                const double depth = a.radius + b.radius - (a.place - b.place).norm();
                if (depth >= 0)
                {
                    largest = std::max(largest, depth / std::min(a.radius, b.radius));
                    sum += depth / std::min(a.radius, b.radius);
                    ++pairs;
                }
            }
        }
        ASSERT_GT(pairs, 20);
        const QualityReport report = packing.in(room());
        EXPECT_NEAR(report.maxOverlap, largest, 1e-12) << seed;
        EXPECT_NEAR(report.meanOverlap, sum / pairs, 1e-12) << seed;
    }
}

TEST(Examine, MeasuresHowDeepASphereIsInAWall)
{
    EXPECT_NEAR(Packing().addRunning({0, 0, 9.8}, 1).in(room()).maxWallOverlap, 0.8, 1e-14);
    EXPECT_NEAR(Packing().addRunning({0, 9.25, 3}, 1).in(room()).maxWallOverlap, 0.25, 1e-14);
    EXPECT_NEAR(Packing().addRunning({-9.7, 0, 3}, 0.5).in(room()).maxWallOverlap, 0.4, 1e-14);
    EXPECT_EQ(Packing().addRunning({0, 0, 8.9}, 1).in(room()).maxWallOverlap, 0);
}

TEST(Examine, MeasuresACentreOnTheWallAsOneRadius)
{
    // In a face, on an edge, at a corner of four faces, and at one of the room.
    for (const Vector3d& place : {Vector3d(0.3, -10, 0.2), Vector3d(1.7, -10, 3.1),
                                  Vector3d(0, -10, 2.2), Vector3d(0, -10, 0), Vector3d(10, 10, 10)})
    {
        EXPECT_NEAR(Packing().addRunning(place).in(room()).maxWallOverlap, 1, 1e-12)
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
    const QualityReport report = Packing().addRunning({0.3, 0.4, 0.1}).in(mesh);
    EXPECT_NEAR(report.maxWallOverlap, 0.5, 1e-14);
    EXPECT_EQ(report.centresOutside, 0u);
}

TEST(Examine, CountsNoneSomeOrAllThatNothingCarries)
{
    Packing packing;
    packing.add({0, -9, 0}).add({0, -7, 0}).add({5, -9, 5});
    EXPECT_EQ(packing.in(room()).unsupported, 0u);
    packing.add({5, 0, 5}).add({-5, 0, 5});
    EXPECT_EQ(packing.in(room()).unsupported, 2u);
    EXPECT_EQ(Packing().add({5, 0, 5}).add({-5, 9, 5}).in(room()).unsupported, 2u);
}

TEST(Examine, AsksOnlySpheresAtRestForSupportAndOnlyThoseCarry)
{
    EXPECT_EQ(Packing().addRunning({5, 0, 5}).in(room()).unsupported, 0u);
    EXPECT_EQ(Packing().addRunning({0, -9, 0}).add({0, -7, 0}).in(room()).unsupported, 1u);
}

TEST(Examine, TakesACeilingAndASphereAboveForNoSupport)
{
    EXPECT_EQ(Packing().add({0, 9, 0}).in(room()).unsupported, 1u);
    EXPECT_EQ(Packing().add({0, 0, 0}).addRunning({0, 2, 0}).in(room()).unsupported, 1u);
}

// A gap counts as a contact up to a hundredth of the sphere's own radius.
TEST(Examine, TakesAGapForAContactUpToAHundredthOfTheRadius)
{
    for (const double radius : {1.0, 0.25})
    {
        for (const auto& [gap, unsupported] : {std::pair(0.0099, 0u), {0.0101, 1u}})
        {
            const double height = radius * (1 + gap);
            Packing onFloor;
            onFloor.add({0, -10 + height, 0}, radius).addRunning({5, 5, 5});
            EXPECT_EQ(onFloor.in(room()).unsupported, unsupported) << radius << " " << gap;
            Packing onSphere;
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
        Packing packing;
        packing.add({0, -9, 0}).add(Vector3d(0, -9, 0) + 2 * normal);
        EXPECT_EQ(packing.in(room()).unsupported, unsupported) << share;
    }
}

TEST(Examine, KnowsThatTwoAndThreeContactsCarryTogether)
{
    Packing groove; // along the edge of floor and wall: each alone would not do, at 45 degrees
    const double c = std::sqrt(2.0);
    groove.add({-c, -9, 0}).add({c, -9, 0}).add({0, -9 + c, 0});
    EXPECT_EQ(groove.in(room()).unsupported, 0u);
    Packing three;
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
    const Packing onZ = Packing().add({0, 0, -9});
    EXPECT_EQ(onZ.in(room(), Axis::z).unsupported, 0u);
    EXPECT_EQ(onZ.in(room(), Axis::y).unsupported, 1u);
    EXPECT_EQ(Packing().add({-9, 0, 0}).in(room(), Axis::x).unsupported, 0u);
}

/// Few spheres are looked at by winding number, many by the surface's pseudonormals; so each sphere
/// is there once or 300 times.
class CentresOutside : public ::testing::TestWithParam<bool>
{
protected:
    [[nodiscard]] static TriangleMesh box(const Vector3d& low, const Vector3d& high)
    {
        return shapes::box(low, high, GetParam() ? 20 : 2);
    }
    [[nodiscard]] static std::size_t outside(const TriangleMesh& mesh,
                                             const std::vector<Vector3d>& centres)
    {
        const std::size_t copies = GetParam() ? 300 : 1;
        Packing packing;
        for (std::size_t k = 0; k < copies; ++k)
        {
            for (const Vector3d& centre : centres)
            {
                packing.addRunning(centre);
            }
        }
        const std::size_t count = packing.in(mesh).centresOutside;
        EXPECT_EQ(count % copies, 0u);
        return count / copies;
    }
};

TEST_P(CentresOutside, AreCountedWhereverTheyAre)
{
    const TriangleMesh mesh = box({-10, -10, -10}, {10, 10, 10});
    EXPECT_EQ(outside(mesh, {{0, 0, 0}, {9.999, 0.1, 0.2}}), 0u);
    EXPECT_EQ(outside(mesh, {{0, 0, 0}, {10.001, 0.1, 0.2}, {0, -30, 0}, {11, 11, 11}}), 3u);
}

TEST_P(CentresOutside, AreKnownInAMeshThatTouchesItself)
{
    // Two boxes that meet in the edge along z; between them are two wedges of air.
    TriangleMesh mesh = box({-10, -10, -10}, {0, 0, 10});
    const TriangleMesh other = box({0, 0, -10}, {10, 10, 10});
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& t : other.triangles)
    {
        mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    EXPECT_EQ(outside(mesh, {{-0.02, -0.01, 0.3}, {0.01, 0.02, 0.3}, {5, 5, 5}}), 0u);
    EXPECT_EQ(outside(mesh, {{-0.01, 0.02, 0.3}, {0.02, -0.01, 0.3}, {-5, 5, 5}, {5, 5, 5}}), 3u);
}

TEST_P(CentresOutside, AreKnownInAThinMesh)
{
    // A thousandth of a radius thick: both sheets are near every centre.
    const TriangleMesh mesh = box({-10, -10, 0}, {10, 10, 1e-3});
    EXPECT_EQ(outside(mesh, {{1, 1, 1e-4}, {1, 1, 9e-4}, {-3, 4, 5e-4}}), 0u);
    EXPECT_EQ(outside(mesh, {{1, 1, -1e-4}, {1, 1, 1.1e-3}, {-3, 4, 5e-4}}), 2u);
}

std::string nameOfWay(const ::testing::TestParamInfo<bool>& info)
{
    return info.param ? "ByPseudonormals" : "ByWindingNumber";
}

INSTANTIATE_TEST_SUITE_P(BothWays, CentresOutside, ::testing::Bool(), nameOfWay);

TEST(Examine, CountsPositionsThatAreNotNumbersAndJudgesTheRest)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    Packing packing;
    packing.add({nan, 0, 0}).add({0, infinity, 0}).addRunning({0, nan, nan});
    packing.add({0, 0, 0}).add({1.5, 0, 0});
    const QualityReport report = packing.in(room());
    EXPECT_EQ(report.notFinite, 3u);
    EXPECT_EQ(report.centresOutside, 0u);
    EXPECT_EQ(report.unsupported, 2u);
    EXPECT_NEAR(report.maxOverlap, 0.5, 1e-14);
}

TEST(Examine, AddsUpVolumes)
{
    const QualityReport report =
        Packing().add({0, -9, 0}).add({5, -9.5, 0}, 0.5).addRunning({0, 5, 0}, 2).in(room());
    EXPECT_NEAR(report.meshVolume, 8000, 1e-9);
    EXPECT_NEAR(report.sphereVolume, 4.0 / 3.0 * M_PI * (1 + 0.125 + 8), 1e-12);
    EXPECT_TRUE(std::isnan(report.volumeEstimate)) << "it is known only for full objects";
}

// Spheres are looked at in parts, which threads share.
TEST(Examine, LeavesOutNoneOfThousands)
{
    const TriangleMesh mesh = shapes::box({-20, -20, -20}, {20, 20, 20}, 4);
    Packing packing;
    std::size_t count = 0;
    for (int k = 0; k < 17 * 17 * 17; ++k)
    {
        const Vector3d cell(k % 17 - 8, k / 17 % 17 - 8, k / 289 - 8);
        packing.add(2.2 * cell);
        ++count;
    }
    EXPECT_EQ(packing.in(mesh).unsupported, count);
    EXPECT_EQ(packing.in(mesh).maxOverlap, 0);
    packing.add({17.6, 17.6, 17.6 + 1.9}).add({0, 21.5, 0}).add({0, std::nan(""), 0});
    const QualityReport report = packing.in(mesh);
    EXPECT_EQ(report.unsupported, count + 2);
    EXPECT_NEAR(report.maxOverlap, 0.1, 1e-12);
    EXPECT_NEAR(report.meanOverlap, 0.1, 1e-12);
    EXPECT_NEAR(report.maxWallOverlap, 0.5, 1e-12);
    EXPECT_EQ(report.centresOutside, 1u);
    EXPECT_EQ(report.notFinite, 1u);
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

TEST(Examine, ReportsWhatTheRunHasCounted)
{
    const auto world = smallWorld(room());
    world->energy.enter(10, 10.5, 100); // gains half a per cent of a fall
    world->energy.enter(10.5, 9, 100);
    world->energy.enter(9, 11, 100);
    world->restoreDiscarded();
    const QualityReport report = examine(*world);
    EXPECT_NEAR(report.energyGain, 0.02, 1e-15);
    EXPECT_NEAR(report.energyExcess, 0.01, 1e-15);
    EXPECT_EQ(report.restoredDiscards, 1u);
}

// What is lost cannot be gained again: the sum counts, and the largest fall is its measure.
TEST(EnergyBalance, ExceedsTheStartOnlyByWhatIsGainedInAll)
{
    EnergyBalance balance;
    balance.enter(10, 8, 50);
    balance.enter(8, 9, 100);
    EXPECT_NEAR(balance.largestGain(), 0.01, 1e-15);
    EXPECT_EQ(balance.excess(), 0);
    balance.enter(9, 12, 100);
    EXPECT_NEAR(balance.largestGain(), 0.03, 1e-15);
    EXPECT_NEAR(balance.excess(), 0.02, 1e-15);
}

// The estimate is N v / phi + c r S, for an object that is full of equal spheres.
TEST(Examine, EstimatesTheVolumeOfAFullObjectWithinItsUncertainty)
{
    const auto world = smallWorld(room());
    for (int k = 0; k < 1000; ++k)
    {
        addResting(*world, {0, 0, 0});
    }
    world->full = true;
    const QualityReport report = examine(*world);
    const double taken = 1000 * 4.0 / 3.0 * M_PI / 0.5951;
    EXPECT_NEAR(report.volumeEstimate, taken + 0.3620 * 2400, 1e-9);
    const double ofShape = report.volumeEstimate * 0.0130; // r S / V is 0.3, where it was fitted
    const double ofCount = taken * 0.14 / std::sqrt(1000.0);
    EXPECT_NEAR(report.volumeEstimateError, std::hypot(ofShape, ofCount), 1e-9);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
// The judge against every pair, closed forms, and what the run has counted.

#include "base/random.hpp"
#include "support/small_world.hpp"
#include "unit/simulation/quality/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

using Eigen::Vector3d;

// The oracle is every pair.
TEST(Examine, AgreesWithAllPairsOnRandomSpheres)
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
        HandPacking packing;
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
        HandPacking packing;
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

TEST(Examine, CountsOnTheFrictionUnderWhichSpheresSettled)
{
    HandPacking wedged;
    wedged.add({0, 0, 0});
    const TriangleMesh gap = shapes::box({-1, -5, -5}, {1, 5, 5});
    EXPECT_EQ(wedged.in(gap).unsupported, 1U);
    JudgeSettings settled;
    settled.settledWith = 0.3;
    EXPECT_EQ(wedged.in(gap, Axis::y, settled).unsupported, 0U);
    JudgeSettings asked;
    asked.friction = 0.3;
    EXPECT_EQ(wedged.in(gap, Axis::y, asked).unsupported, 0U);
}

// The upper of two leans: its moment is the weight times the radius times the sine, and the reduced
// radius is half of the radius.
TEST(Examine, CountsOnTheRollingFrictionUnderWhichSpheresSettled)
{
    const double lean = 0.6;
    HandPacking pair;
    pair.add({0, -9, 0}).add({2 * std::sin(lean), -9 + 2 * std::cos(lean), 0});
    JudgeSettings settled;
    settled.settledWith = 1;
    EXPECT_EQ(pair.in(room(), Axis::y, settled).unsupported, 1U) << "it rolls";
    settled.rollingFriction = 1.1 * std::tan(lean);
    EXPECT_EQ(pair.in(room(), Axis::y, settled).unsupported, 1U) << "enough on a plane";
    settled.rollingFriction = 2 * std::tan(lean);
    EXPECT_EQ(pair.in(room(), Axis::y, settled).unsupported, 0U);
}

TEST(Examine, AddsUpVolumes)
{
    const QualityReport report =
        HandPacking().add({0, -9, 0}).add({5, -9.5, 0}, 0.5).addRunning({0, 5, 0}, 2).in(room());
    EXPECT_NEAR(report.meshVolume, 8000, 1e-9);
    EXPECT_NEAR(report.sphereVolume, 4.0 / 3.0 * M_PI * (1 + 0.125 + 8), 1e-12);
    EXPECT_TRUE(std::isnan(report.volumeEstimate)) << "it is known only for full objects";
}

// Spheres are looked at in parts, which threads share.
TEST(Examine, LeavesOutNoneOfThousands)
{
    const TriangleMesh mesh = shapes::box({-20, -20, -20}, {20, 20, 20}, 4);
    HandPacking packing;
    std::size_t count = 0;
    for (int k = 0; k < 17 * 17 * 17; ++k)
    {
        const Eigen::Vector3i cell(k % 17 - 8, k / 17 % 17 - 8, k / 289 - 8);
        packing.add(2.2 * cell.cast<double>());
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

TEST(Examine, ReportsWhatTheRunHasCounted)
{
    const auto world = smallWorld(room());
    world->counts.energy.enter(10, 10.5, 100); // gains half a per cent of a fall
    world->counts.energy.enter(10.5, 9, 100);
    world->counts.energy.enter(9, 11, 100);
    const QualityReport report = examine(*world);
    EXPECT_NEAR(report.energyGain, 0.02, 1e-15);
    EXPECT_NEAR(report.energyExcess, 0.01, 1e-15);
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
    world->clock.full = true;
    const QualityReport report = examine(*world);
    const double taken = 1000 * 4.0 / 3.0 * M_PI / 0.5951;
    EXPECT_NEAR(report.volumeEstimate, taken + 0.3620 * 2400, 1e-9);
    const double ofShape = report.volumeEstimate * 0.0130; // r S / V is 0.3, where it was fitted
    const double ofCount = taken * 0.14 / std::sqrt(1000.0);
    EXPECT_NEAR(report.volumeEstimateError, std::hypot(ofShape, ofCount), 1e-9);
}

} // namespace
} // namespace frostfill

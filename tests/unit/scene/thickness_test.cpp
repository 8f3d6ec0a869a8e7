// SPDX-License-Identifier: MIT
#include "scene/thick_parts.hpp"
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace frostfill
{
namespace
{

using Samples = std::vector<ThicknessSample>;

Samples samplesOf(const TriangleMesh& mesh, std::size_t count, bool onlyBehind)
{
    return sampleThickness(mesh, TriangleBvh(mesh), count, onlyBehind);
}

double sum(const Samples& samples, double ThicknessSample::*field)
{
    double total = 0;
    for (const ThicknessSample& sample : samples)
    {
        total += sample.*field;
    }
    return total;
}

/// Of the area.
double shareWith(const Samples& samples, const std::function<bool(double)>& thickness)
{
    double area = 0;
    for (const ThicknessSample& sample : samples)
    {
        area += thickness(sample.thickness) ? sample.area : 0;
    }
    return area / sum(samples, &ThicknessSample::area);
}

TEST(Thickness, OfAPlateIsHalfTheDistanceOfItsSides)
{
    const Samples plate = samplesOf(shapes::box({0, 0, 0}, {40, 40, 1}), 500, true);
    EXPECT_EQ(plate.size(), 500u);
    EXPECT_GT(shareWith(plate, [](double t) { return std::abs(t - 0.5) < 1e-4; }), 0.9);
    EXPECT_EQ(shareWith(plate, [](double t) { return t > 0.5 + 1e-9; }), 0);
}

TEST(Thickness, SharesOutTheAreaAndTheVolume)
{
    for (const TriangleMesh& mesh :
         {shapes::box({0, 0, 0}, {1, 2, 3}), shapes::box({0, 0, 0}, {9, 9, 1}), shapes::torus()})
    {
        const Samples samples = samplesOf(mesh, 1000, true);
        EXPECT_NEAR(sum(samples, &ThicknessSample::area) / surfaceArea(mesh), 1, 1e-9);
        EXPECT_NEAR(sum(samples, &ThicknessSample::volume) / signedVolume(mesh), 1, 0.08);
    }
}

TEST(Thickness, FacetsOfARoundWallDoNotPassForThinParts)
{
    const Samples tube = samplesOf(shapes::torus(1, 0.4, 48, 12), 1000, true);
    EXPECT_GT(shareWith(tube, [](double t) { return t > 0.36; }), 0.95);
}

TEST(Thickness, OfAHollowBoxIsThatOfItsWalls)
{
    TriangleMesh hollow = shapes::box({0, 0, 0}, {10, 10, 10});
    TriangleMesh cavity = shapes::box({1, 1, 1}, {9, 9, 9});
    test::flipAll(cavity);
    test::append(hollow, cavity);
    const Samples walls = samplesOf(hollow, 1000, false);
    EXPECT_GT(shareWith(walls, [](double t) { return t > 0.49; }), 0.9);
    EXPECT_LT(samplesOf(hollow, 1000, false).front().thickness, 0.75) << "in a corner";
}

TEST(Thickness, OfAWallInsideIsThatOfBothSides)
{
    TriangleMesh crossing = shapes::box({0, 0, 0}, {10, 10, 2});
    test::append(crossing, shapes::box({4, 4, -4}, {6, 6, 6}));
    const Samples samples = samplesOf(crossing, 1000, false);
    EXPECT_GT(samples.size(), 1000u);
    for (const ThicknessSample& sample : samples)
    {
        EXPECT_LE(sample.thickness, 1 + 1e-9) << "no ball inside passes through a wall";
    }
}

TEST(Thickness, IsTheSameEachTime)
{
    const Samples first = samplesOf(shapes::torus(), 200, true);
    const Samples second = samplesOf(shapes::torus(), 200, true);
    for (std::size_t k = 0; k < first.size(); ++k)
    {
        EXPECT_EQ(first[k].thickness, second[k].thickness);
    }
}

} // namespace
} // namespace frostfill

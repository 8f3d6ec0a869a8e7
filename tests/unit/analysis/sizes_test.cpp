// SPDX-License-Identifier: MIT
#include "support/shapes.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

SizeProfiles sizesOf(const Packing& packing)
{
    AnalysisSettings settings;
    settings.only = {AnalysisKind::sizes};
    settings.bins = 4;
    settings.below = 4;
    return *analysePacking(shapes::box({-2, 0, -2}, {2, 4, 2}), packing, settings).sizes;
}

Packing layers(double growth)
{
    Packing packing;
    for (int layer = 0; layer < 4; ++layer)
    {
        for (const double x : {-1.0, 0.0, 1.5})
        {
            packing.centres.emplace_back(x, layer + 0.5, 0.25);
            packing.radii.push_back(0.1 + growth * layer + (x > 0 ? 0.02 : 0));
        }
    }
    packing.atRest.assign(packing.radii.size(), true);
    return packing;
}

TEST(SizesOfAPacking, AreThoseOfTheSpheresAtEachHeight)
{
    const SizeProfiles sizes = sizesOf(layers(0.05));
    ASSERT_EQ(sizes.height.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k)
    {
        const SizeBin& bin = sizes.height[k];
        EXPECT_EQ(bin.from, static_cast<double>(k));
        EXPECT_EQ(bin.spheres, 3U);
        EXPECT_NEAR(bin.meanRadius, 0.1 + 0.05 * static_cast<double>(k) + 0.02 / 3, 1e-15);
        EXPECT_NEAR(bin.deviation, 0.02 * std::sqrt(2.0) / 3, 1e-15);
    }
    EXPECT_GT(sizes.withHeight, 0.9);
    EXPECT_LT(sizesOf(layers(-0.02)).withHeight, -0.8);
}

TEST(SizesOfAPacking, AreThoseAtEachDistanceFromTheAxis)
{
    const SizeProfiles sizes = sizesOf(layers(0));
    ASSERT_EQ(sizes.radial.size(), 3U); // 0.25, 1.03 and 1.52 of 2.83, in quarters
    EXPECT_NEAR(sizes.radial[0].meanRadius, 0.1, 1e-15);
    EXPECT_NEAR(sizes.radial[2].meanRadius, 0.12, 1e-15);
    EXPECT_EQ(sizes.radial[2].spheres, 4U);
    EXPECT_NEAR(sizes.withHeight, 0, 1e-12);
    EXPECT_GT(sizes.withRadial, 0.5);
}

TEST(SizesOfAPacking, OfEqualSpheresGoWithNothing)
{
    Packing packing = layers(0);
    packing.radii.assign(packing.radii.size(), 0.1);
    EXPECT_TRUE(std::isnan(sizesOf(packing).withHeight));
    EXPECT_TRUE(std::isnan(sizesOf(packing).withRadial));
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "unit/analysis/lattices.hpp"
#include "unit/analysis/mixed_spheres.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frostfill
{
namespace
{

PairCorrelation pairsOf(const TriangleMesh& mesh, const Packing& packing, double range)
{
    AnalysisSettings settings;
    settings.only = {AnalysisKind::pairs};
    settings.range = range;
    settings.below = 1e3; // of all that the mesh encloses
    return *analysePacking(mesh, packing, settings).pairs;
}

TEST(PairCorrelation, CountsEveryNeighbourOfSpheresAwayFromWalls)
{
    const Packing packing = test::mixedSpheres(3000, 0.1, 8);
    const PairCorrelation pairs = pairsOf(loadMesh("cube").mesh, packing, 4);
    std::size_t centres = 0;
    std::vector<std::size_t> counts(pairs.bins.size(), 0);
    for (std::size_t i = 0; i < packing.radii.size(); ++i)
    {
        if (1 - packing.centres[i].lpNorm<Eigen::Infinity>() < pairs.range)
        {
            continue;
        }
        ++centres;
        for (std::size_t j = 0; j < packing.radii.size(); ++j)
        {
            const double apart = (packing.centres[i] - packing.centres[j]).norm();
            for (std::size_t bin = 0; bin < counts.size(); ++bin)
            {
                counts[bin] += i != j && apart <= pairs.bins[bin].to ? 1 : 0;
            }
        }
    }
    ASSERT_EQ(pairs.centres, centres);
    for (std::size_t bin = 0; bin < counts.size(); ++bin)
    {
        EXPECT_NEAR(pairs.bins[bin].neighbours,
                    static_cast<double>(counts[bin]) / static_cast<double>(centres), 1e-9);
    }
    EXPECT_EQ(pairs.bins.back().to, pairs.range);
}

// Places that know nothing of one another have as many neighbours at any distance.
TEST(PairCorrelation, IsOneForPlacesAtRandom)
{
    const PairCorrelation pairs =
        pairsOf(loadMesh("cube").mesh, test::mixedSpheres(20000, 0.02, 1), 10);
    double sum = 0;
    for (std::size_t bin = pairs.bins.size() / 2; bin < pairs.bins.size(); ++bin)
    {
        sum += pairs.bins[bin].g;
        EXPECT_NEAR(pairs.bins[bin].g, 1, 0.1);
    }
    EXPECT_NEAR(sum / static_cast<double>(pairs.bins.size() - pairs.bins.size() / 2), 1, 0.01);
    EXPECT_NEAR(pairs.numberDensity, 20000.0 / 8, 100);
}

TEST(PairCorrelation, ReachesAsFarAsAnObjectHasRoom)
{
    const Packing packing = test::packingOf(test::lattices()[0], 6, 1);
    const PairCorrelation pairs = pairsOf(test::boxAround(packing), packing, 5);
    EXPECT_NEAR(pairs.range, 1.5, 1e-12); // 4^3 spheres of 6^3 are so far from walls
    EXPECT_EQ(pairs.centres, 64U);
}

// A crystal's number density is known, and that of small balls is far from it unless the sphere in
// the middle counts: within 1.5 diameters of a sphere of a simple cubic crystal there are 19.
TEST(PairCorrelation, CountsTheSphereItselfInItsDensity)
{
    const Packing packing = test::packingOf(test::lattices()[0], 6, 1);
    const PairCorrelation pairs = pairsOf(test::boxAround(packing), packing, 1.5);
    const double ball = 4.0 / 3.0 * std::numbers::pi * 1.5 * 1.5 * 1.5;
    EXPECT_NEAR(pairs.numberDensity, 19 / ball, 1e-12);
    double neighbours = 0;
    for (const PairBin& bin : pairs.bins)
    {
        const double shell =
            4.0 / 3.0 * std::numbers::pi * (std::pow(bin.to, 3) - std::pow(bin.from, 3));
        neighbours += bin.g * shell * 19 / ball;
    }
    EXPECT_NEAR(neighbours, 18, 1e-9);
}

} // namespace
} // namespace frostfill

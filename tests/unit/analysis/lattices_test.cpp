// SPDX-License-Identifier: MIT
#include "unit/analysis/lattices.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using test::boxAround;
using test::Lattice;
using test::packingOf;

constexpr double kDiameter = 0.7;
constexpr int kTimes = 9;
constexpr double kWhole = 1e3; ///< above any mesh here

/// A lattice in the box around it, and its analysis.
class LatticeIn : public ::testing::TestWithParam<Lattice>
{
protected:
    [[nodiscard]] PackingAnalysis analyse(AnalysisSettings settings) const
    {
        settings.range = 2;
        settings.samples = 1 << 15;
        const Packing packing = packingOf(GetParam(), kTimes, kDiameter);
        return analysePacking(boxAround(packing), packing, settings);
    }
    [[nodiscard]] PackingAnalysis only(AnalysisKind kind) const
    {
        return analyse({.only = {kind}});
    }
};

TEST_P(LatticeIn, HasTheContactsOfItsKindAndNoRattlers)
{
    const PackingAnalysis analysis = only(AnalysisKind::contacts);
    EXPECT_EQ(analysis.contacts->meanInside, GetParam().neighbours);
    EXPECT_LT(analysis.contacts->mean, GetParam().neighbours);
    EXPECT_EQ(analysis.contacts->meanHeld, analysis.contacts->mean);
    EXPECT_EQ(analysis.contacts->rattlers, 0U);
}

TEST_P(LatticeIn, HasItsShellsOfNeighboursWhereTheyAre)
{
    const PackingAnalysis analysis = only(AnalysisKind::pairs);
    const PairCorrelation& pairs = *analysis.pairs;
    EXPECT_NEAR(pairs.range, 2 * kDiameter, 1e-12);
    EXPECT_GT(pairs.centres, 100U);
    const double shells[] = {1, GetParam().secondDistance};
    for (const PairBin& bin : pairs.bins)
    {
        const double expected = bin.to < shells[0] * kDiameter   ? 0
                                : bin.to < shells[1] * kDiameter ? GetParam().neighbours
                                                                 : GetParam().secondShell;
        if (bin.to < 1.5 * kDiameter)
        {
            EXPECT_DOUBLE_EQ(bin.neighbours, expected) << bin.from;
        }
        const double volume =
            4.0 / 3 * std::numbers::pi * (std::pow(bin.to, 3) - std::pow(bin.from, 3));
        if (bin.from < kDiameter && kDiameter < bin.to)
        {
            EXPECT_NEAR(bin.g * volume * pairs.numberDensity, GetParam().neighbours, 1e-9);
        }
    }
}

TEST_P(LatticeIn, HasTheOrderOfItsKind)
{
    const PackingAnalysis analysis = only(AnalysisKind::order);
    const OrderStatistics& order = *analysis.order;
    EXPECT_NEAR(order.mean, GetParam().q6, 1e-12);
    EXPECT_NEAR(order.global, GetParam().q6, 1e-12);
    for (std::size_t k = 0; k < analysis.ids.size(); ++k)
    {
        if (analysis.wallDistances[k] > 1.5 * kDiameter)
        {
            EXPECT_EQ(order.bonds[k], GetParam().bonded);
            EXPECT_NEAR(order.q6[k], GetParam().q6, 1e-12);
        }
    }
    EXPECT_GT(order.inside, 0U);
}

TEST_P(LatticeIn, HasCellsThatAreAllAlike)
{
    if (!hasVoronoiCells())
    {
        GTEST_SKIP() << missingVoronoiCells();
    }
    const PackingAnalysis analysis = only(AnalysisKind::cells);
    const CellStatistics& cells = *analysis.cells;
    const double volume =
        std::pow(GetParam().edge * kDiameter, 3) / static_cast<double>(GetParam().basis.size());
    double inCells = 0;
    for (std::size_t k = 0; k < analysis.ids.size(); ++k)
    {
        const double wall = analysis.wallDistances[k] / kDiameter;
        EXPECT_TRUE(wall > 0.51 || cells.kinds[k] == CellKind::atWall) << k;
        if (wall > 1.4) // nearer ones are whole or not, and lack second neighbours
        {
            ASSERT_EQ(cells.kinds[k], CellKind::whole) << k;
            EXPECT_NEAR(cells.volumes[k], volume, 1e-12 * volume);
            EXPECT_NEAR(cells.fractions[k], GetParam().fraction, 1e-12);
        }
        inCells += cells.kinds[k] == CellKind::whole ? cells.volumes[k] : 0;
    }
    EXPECT_GT(cells.whole, 100U);
    EXPECT_EQ(cells.open, 0U);
    const double inSpheres = static_cast<double>(cells.whole) * analysis.sphereVolume /
                             static_cast<double>(analysis.ids.size());
    EXPECT_NEAR(cells.fraction, inSpheres / inCells, 1e-12);
}

TEST_P(LatticeIn, HasThePorosityOfItsSpheres)
{
    const PackingAnalysis analysis = analyse({.below = kWhole, .only = {AnalysisKind::porosity}});
    const double free = 1 - analysis.sphereVolume / analysis.meshVolume;
    EXPECT_NEAR(analysis.porosity->whole.porosity, free, 5 * analysis.porosity->whole.error);
    EXPECT_LT(analysis.porosity->whole.error, 0.003);
    double filled = 0;
    double volume = 0;
    for (const PorosityBin& bin : analysis.porosity->height)
    {
        filled += (1 - bin.porosity) * bin.objectVolume;
        volume += bin.objectVolume;
        EXPECT_EQ(bin.error, 0);
    }
    EXPECT_TRUE(analysis.porosity->slabsAreExact);
    EXPECT_NEAR(filled, analysis.sphereVolume, 1e-12 * analysis.sphereVolume);
    EXPECT_NEAR(volume, analysis.meshVolume, 1e-12 * analysis.meshVolume);
}

// In a box that repeats no sphere is at a wall, wherever the box begins.
TEST_P(LatticeIn, HasAllNeighboursOfEachSphereInABoxThatRepeats)
{
    const test::Lattice& lattice = GetParam();
    Packing packing = test::packingOf(lattice, 4, 1);
    packing.centres.front() += Eigen::Vector3d(4 * lattice.edge, -8 * lattice.edge, 0);
    const TriangleMesh box =
        shapes::box(test::kCorner, test::kCorner + Eigen::Vector3d::Constant(4 * lattice.edge));
    AnalysisSettings settings{.bounds = AnalysisBounds::periodic, .range = 2};
    const PackingAnalysis found = analysePacking(box, packing, settings);
    EXPECT_EQ(found.outside, 0U);
    EXPECT_EQ(found.contacts->mean, lattice.neighbours);
    EXPECT_EQ(found.contacts->meanInside, lattice.neighbours);
    EXPECT_EQ(found.contacts->walls, std::vector<std::uint32_t>(packing.radii.size(), 0));
    for (const double q6 : found.order->q6)
    {
        EXPECT_NEAR(q6, lattice.q6, 1e-9);
    }
    EXPECT_EQ(found.pairs->centres, packing.radii.size());
    const auto second =
        std::find_if(found.pairs->bins.begin(), found.pairs->bins.end(),
                     [&](const PairBin& bin) { return bin.to > lattice.secondDistance + 0.005; });
    EXPECT_EQ(second->neighbours, lattice.secondShell);
    EXPECT_FALSE(found.porosity || found.cells);
}

INSTANTIATE_TEST_SUITE_P(Kinds, LatticeIn, ::testing::ValuesIn(test::lattices()),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "unit/analysis/lattices.hpp"
#include "unit/analysis/mixed_spheres.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

class VoronoiCells : public ::testing::Test
{
protected:
    void SetUp() override
    {
        if (!hasVoronoiCells())
        {
            GTEST_SKIP() << missingVoronoiCells();
        }
    }
    [[nodiscard]] static CellStatistics cellsOf(const TriangleMesh& mesh, const Packing& packing)
    {
        AnalysisSettings settings;
        settings.only = {AnalysisKind::cells};
        return *analysePacking(mesh, packing, settings).cells;
    }
};

/// The sphere whose cell a place is in: the one with the smallest power.
std::size_t ownerOf(const Packing& packing, const Eigen::Vector3d& place)
{
    std::size_t owner = 0;
    double least = 1e300;
    for (std::size_t k = 0; k < packing.radii.size(); ++k)
    {
        const double power =
            (place - packing.centres[k]).squaredNorm() - std::pow(packing.radii[k], 2);
        if (power < least)
        {
            least = power;
            owner = k;
        }
    }
    return owner;
}

Eigen::Vector3d placeInCube(std::uint64_t k)
{
    return {2 * uniformRandom(4, k, 0) - 1, 2 * uniformRandom(4, k, 1) - 1,
            2 * uniformRandom(4, k, 2) - 1};
}

TEST_F(VoronoiCells, OfManySizesHoldThePlacesOfLeastPower)
{
    const Packing packing = test::mixedSpheres(900, 0.15, 6);
    const CellStatistics cells = cellsOf(loadMesh("cube").mesh, packing);
    ASSERT_GT(cells.whole, 300U);
    constexpr std::uint64_t kPlaces = 60000;
    std::vector<double> found(packing.radii.size(), 0);
    for (std::uint64_t k = 0; k < kPlaces; ++k)
    {
        ++found[ownerOf(packing, placeInCube(k))];
    }
    double all = 0;
    double deviations = 0;
    for (std::size_t k = 0; k < packing.radii.size(); ++k)
    {
        if (cells.kinds[k] == CellKind::whole)
        {
            const double expected = cells.volumes[k] / 8 * kPlaces;
            deviations += std::pow(found[k] - expected, 2) / expected;
            all += found[k] - expected;
        }
        EXPECT_TRUE(cells.kinds[k] != CellKind::none || found[k] == 0) << k;
    }
    EXPECT_NEAR(deviations / static_cast<double>(cells.whole), 1, 0.4);
    EXPECT_LT(std::abs(all), 5 * std::sqrt(kPlaces));
}

TEST_F(VoronoiCells, ThatAPlaceOfAWallBelongsToAreCutByIt)
{
    const Packing packing = test::mixedSpheres(600, 0.15, 6);
    const CellStatistics cells = cellsOf(loadMesh("cube").mesh, packing);
    for (std::uint64_t k = 0; k < 20000; ++k)
    {
        Eigen::Vector3d place = placeInCube(k);
        place[static_cast<Eigen::Index>(k % 3)] = k % 2 == 0 ? -1 : 1;
        EXPECT_EQ(cells.kinds[ownerOf(packing, place)], CellKind::atWall);
    }
}

// The walls of a ring bend into the cells beside its hole.
TEST_F(VoronoiCells, BesideTheHoleOfARingAreCutByIt)
{
    const TriangleMesh ring = shapes::torus(1, 0.45, 96, 48);
    Packing packing;
    for (std::uint64_t k = 0; packing.radii.size() < 4000; ++k)
    {
        const Eigen::Vector3d place = placeInCube(k).cwiseProduct(Eigen::Vector3d(1.5, 1.5, 0.5));
        if (std::hypot(std::hypot(place.x(), place.y()) - 1, place.z()) < 0.44)
        {
            packing.centres.push_back(place);
            packing.radii.push_back(0.01);
        }
    }
    packing.atRest.assign(packing.radii.size(), true);
    const CellStatistics cells = cellsOf(ring, packing);
    EXPECT_GT(cells.whole, 1000U);
    std::size_t wrong = 0;
    for (std::size_t v = 0; v < ring.vertices.size(); v += 3)
    {
        wrong += cells.kinds[ownerOf(packing, ring.vertices[v])] == CellKind::whole ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0U);
}

TEST_F(VoronoiCells, AtAFreeSurfaceAreOpen)
{
    const Packing packing = test::packingOf(test::lattices()[0], 7, 1);
    const Eigen::AlignedBox3d box = boundingBox(test::boxAround(packing));
    const Eigen::Vector3d up(0, 60, 0);
    const CellStatistics cells = cellsOf(shapes::box(box.min(), box.max() + up), packing);
    EXPECT_EQ(cells.whole, 125U);
    EXPECT_EQ(cells.open, 25U);
    EXPECT_EQ(cells.atWall, 343U - 150U);
}

TEST_F(VoronoiCells, OfOnePlaceBelongToTheLargerSphere)
{
    Packing packing = test::packingOf(test::lattices()[0], 5, 1);
    packing.centres.push_back(packing.centres[62]);
    packing.radii.push_back(0.25);
    packing.atRest.push_back(true);
    const CellStatistics cells = cellsOf(test::boxAround(packing), packing);
    EXPECT_EQ(cells.kinds[125], CellKind::none);
    EXPECT_EQ(cells.kinds[62], CellKind::whole);
    EXPECT_NEAR(cells.volumes[62], 1, 1e-12);
}

} // namespace
} // namespace frostfill

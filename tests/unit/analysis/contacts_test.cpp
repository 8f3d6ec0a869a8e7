// SPDX-License-Identifier: MIT
#include "simulation/quality/tolerances.hpp"
#include "unit/analysis/lattices.hpp"
#include "unit/analysis/mixed_spheres.hpp"

#include <frostfill/analysis.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using test::mixedSpheres;

Packing rowOf(std::size_t count)
{
    Packing packing;
    for (std::size_t k = 0; k < count; ++k)
    {
        packing.centres.emplace_back(0.5, 0.5 + static_cast<double>(k), 0.5);
    }
    packing.radii.assign(count, 0.5);
    packing.atRest.assign(count, true);
    return packing;
}

PackingAnalysis contactsOf(const TriangleMesh& mesh, const Packing& packing,
                           AnalysisSettings settings = {})
{
    settings.only = {AnalysisKind::contacts};
    return analysePacking(mesh, packing, settings);
}

TEST(ContactsOfAPacking, AreThoseOfEveryPair)
{
    const Packing packing = mixedSpheres(1500, 0.3, 40);
    const PackingAnalysis analysis =
        contactsOf(loadMesh("cube").mesh, packing, {.contactGap = 0.25});
    std::vector<SphereContact> expected;
    for (std::uint32_t i = 0; i < packing.radii.size(); ++i)
    {
        for (std::uint32_t j = i + 1; j < packing.radii.size(); ++j)
        {
            const double gap = (packing.centres[i] - packing.centres[j]).norm() - packing.radii[i] -
                               packing.radii[j];
            if (gap < 0.25 * std::min(packing.radii[i], packing.radii[j]))
            {
                expected.push_back({i, j, gap});
            }
        }
    }
    ASSERT_EQ(analysis.contacts->network.size(), expected.size());
    std::vector<std::uint32_t> counts(packing.radii.size(), 0);
    for (std::size_t k = 0; k < expected.size(); ++k)
    {
        EXPECT_EQ(analysis.contacts->network[k].first, expected[k].first);
        EXPECT_EQ(analysis.contacts->network[k].second, expected[k].second);
        EXPECT_NEAR(analysis.contacts->network[k].gap, expected[k].gap, 1e-15);
        ++counts[expected[k].first];
        ++counts[expected[k].second];
    }
    EXPECT_EQ(analysis.contacts->spheres, counts);
}

TEST(ContactsOfAPacking, OfAColumnCarryWhatIsAbove)
{
    const TriangleMesh room = shapes::box({-1, 0, -1}, {2, 6, 2});
    const PackingAnalysis analysis = contactsOf(room, rowOf(4), {.forces = 0.5});
    ASSERT_EQ(analysis.contacts->network.size(), 3U);
    for (std::size_t k = 0; k < 3; ++k)
    {
        // Weights of the spheres above press the first one down.
        const Eigen::Vector3d expected(0, static_cast<double>(k) - 3, 0);
        EXPECT_LT((analysis.contacts->network[k].force - expected).norm(), 0.02) << k;
    }
    EXPECT_LT(analysis.contacts->unbalance, 0.02);
    EXPECT_EQ(contactsOf(room, rowOf(4)).contacts->network[0].force.norm(), 0);
}

TEST(ContactsOfAPacking, AreWithWallsOnceForEachOfThem)
{
    // A box whose sides have many triangles, and a sphere in its corner.
    Packing packing = rowOf(1);
    packing.centres.emplace_back(1.5, 0.5, 1.5);
    packing.radii.push_back(0.5);
    packing.atRest.push_back(true);
    const PackingAnalysis analysis = contactsOf(shapes::box({0, 0, 0}, {3, 3, 3}, 6), packing);
    EXPECT_EQ(analysis.contacts->walls, (std::vector<std::uint32_t>{3, 1}));
    EXPECT_EQ(analysis.contacts->spheres, (std::vector<std::uint32_t>{0, 0}));
}

TEST(ContactsOfAPacking, AreAsNearAsTheJudgeSays)
{
    EXPECT_EQ(AnalysisSettings{}.contactGap, kContactGap);
}

// In a shaft as wide as they are each touches four walls and those above and below it. Where six
// are needed, the uppermost is loose without a lid, then the one below it, and so on.
TEST(ContactsOfAPacking, AreTakenFromRattlersAgainAndAgain)
{
    const Packing packing = rowOf(5);
    const PackingAnalysis closed =
        contactsOf(shapes::box({0, 0, 0}, {1, 5, 1}), packing, {.rattlersBelow = 6});
    EXPECT_EQ(closed.contacts->rattlers, 0U);
    EXPECT_DOUBLE_EQ(closed.contacts->mean, 1.6);
    EXPECT_EQ(closed.contacts->meanHeld, closed.contacts->mean);
    const TriangleMesh tall = shapes::box({0, 0, 0}, {1, 6, 1});
    const PackingAnalysis open = contactsOf(tall, packing, {.rattlersBelow = 6});
    EXPECT_EQ(open.contacts->rattlers, 5U);
    EXPECT_TRUE(std::isnan(open.contacts->meanHeld));
    EXPECT_EQ(contactsOf(tall, packing, {.rattlersBelow = 5}).contacts->rattlers, 0U);
}

TEST(ContactsOfAPacking, WithoutRattlersAreThoseBetweenTheOthers)
{
    // The sixth lies beside the fifth, which is the first to hang over the edge of the shaft: with
    // the sixth, that is loose, it loses what it needs.
    Packing packing = rowOf(5);
    packing.centres.emplace_back(1.5, 4.5, 0.5);
    packing.radii.push_back(0.5);
    packing.atRest.push_back(true);
    const TriangleMesh mesh =
        shapes::gridCells({{{0, 1, 9}, {0, 4, 9}, {0, 1}}}, [](const std::array<int, 3>& cell)
                          { return cell[0] == 0 || cell[1] == 1; });
    const PackingAnalysis analysis = contactsOf(mesh, packing, {.rattlersBelow = 5});
    EXPECT_EQ(analysis.contacts->rattler, (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 1}));
    EXPECT_DOUBLE_EQ(analysis.contacts->mean, 10.0 / 6);
    EXPECT_DOUBLE_EQ(analysis.contacts->meanHeld, 6.0 / 4);
}

TEST(BondsOfAPacking, ReachToTheSumOfBothRadii)
{
    const Packing packing = mixedSpheres(800, 0.3, 40);
    AnalysisSettings settings;
    settings.only = {AnalysisKind::order};
    const PackingAnalysis analysis = analysePacking(loadMesh("cube").mesh, packing, settings);
    for (std::size_t i = 0; i < packing.radii.size(); ++i)
    {
        std::uint32_t bonds = 0;
        for (std::size_t j = 0; j < packing.radii.size(); ++j)
        {
            const double apart = (packing.centres[i] - packing.centres[j]).norm();
            bonds += i != j && apart <= 1.3 * (packing.radii[i] + packing.radii[j]) ? 1 : 0;
        }
        EXPECT_EQ(analysis.order->bonds[i], bonds) << i;
    }
}

} // namespace
} // namespace frostfill

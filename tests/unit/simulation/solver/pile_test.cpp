// SPDX-License-Identifier: MIT
// What runners do to one another: collisions, pushes, and who carries whom in a pile.

#include "unit/simulation/solver/pile.hpp"

#include "base/random.hpp"
#include "oracle/motion.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"
#include "simulation/world/spheres.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

std::vector<Eigen::Vector3d> column(int height)
{
    std::vector<Eigen::Vector3d> places;
    places.reserve(static_cast<std::size_t>(height));
    for (int k = 0; k < height; ++k)
    {
        places.emplace_back(0, kFloor + 1 + 2 * k, 0);
    }
    return places;
}

TEST(VelocitySolver, AColumnOnTheFloorStandsStill)
{
    Pile pile(column(7));
    for (int k = 0; k < 50; ++k)
    {
        pile.step();
        for (std::uint32_t row = 0; row < 7; ++row)
        {
            EXPECT_LT(pile.running.velocity[row].norm(), 1e-3);
            EXPECT_NEAR(pile.running.position[row].y(), kFloor + 1 + 2 * row, 2e-3);
        }
    }
}

TEST(VelocitySolver, ARandomCrowdNeverGainsEnergyInAStep)
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::vector<Eigen::Vector3d> places;
        for (std::uint64_t k = 0; k < 27; ++k)
        {
            const auto at = [&](std::uint64_t n, std::uint64_t axis)
            { return 4.5 * (static_cast<double>(n) - 1) + uniformRandom(seed, k, axis); };
            places.emplace_back(at(k % 3, 0), at(k / 9, 1), at(k / 3 % 3, 2));
        }
        Pile pile(places);
        for (std::uint32_t row = 0; row < 27; ++row)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                pile.running.velocity[row][axis] =
                    6 * (uniformRandom(seed, row, 3 + static_cast<std::uint64_t>(axis)) - .5);
            }
        }
        double energy = pile.energy();
        const double fall = 27 * 16;
        for (int k = 0; k < 400; ++k)
        {
            pile.step();
            EXPECT_LE(pile.energy(), energy + 1e-12 * fall);
            energy = std::min(energy, pile.energy());
        }
        for (const Eigen::Vector3d& velocity : pile.running.velocity.all())
        {
            EXPECT_LT(velocity.norm(), 0.5);
        }
    }
}

// In the air and level, so that nothing but their masses tells the two apart.
TEST(VelocitySolver, SpheresOfUnlikeMassPartWithTheClosedFormSpeeds)
{
    for (const double small : {1.0, 0.8, 0.5, 0.25})
    {
        const Eigen::Vector3d normal = Eigen::Vector3d(2, 0, 1).normalized();
        Pile pile({Eigen::Vector3d::Zero(), (1 + small) * normal}, {1, small});
        Eigen::Vector3d& heavy = pile.running.velocity[0];
        Eigen::Vector3d& light = pile.running.velocity[1];
        heavy = 0.7 * normal + Eigen::Vector3d(0, 0.3, 0);
        light = -1.1 * normal;
        pile.positionSolver.resolve(kDt);
        const double mass = small * small * small;
        const oracle::Speeds expected =
            oracle::collide(1, 0.7, mass, -1.1, SolverSettings().restitution.coefficient);
        EXPECT_NEAR(heavy.dot(normal), expected.first, 1e-12);
        EXPECT_NEAR(light.dot(normal), expected.second, 1e-12);
        EXPECT_NEAR(heavy.y(), 0.3, 1e-12);
    }
}

TEST(PositionSolver, SpheresOfUnlikeMassAreTakenApartAboutTheirCentreOfMass)
{
    for (const double small : {1.0, 0.8, 0.5, 0.25})
    {
        const Eigen::Vector3d normal = Eigen::Vector3d(2, 0, 1).normalized();
        const double depth = 0.05 * small;
        Pile pile({Eigen::Vector3d::Zero(), (1 + small - depth) * normal}, {1, small});
        const double mass = small * small * small;
        const auto middle = [&]
        { return (pile.running.position[0] + mass * pile.running.position[1]).eval(); };
        const Eigen::Vector3d before = middle();
        pile.positionSolver.resolve(kDt);
        EXPECT_NEAR((pile.running.position[1] - pile.running.position[0]).norm(), 1 + small, 1e-12);
        EXPECT_LT((middle() - before).norm(), 1e-12) << small;
    }
}

// Three in a line, in the air and level: the first touches the second, which is deep in the third.
// The second is pushed into the first, which must then give way as well.
TEST(PositionSolver, WhoWasClearGivesWayOnceItsNeighbourIsPushedIntoIt)
{
    const double depth = 0.1;
    Pile pile({{-2, 0, 0}, {0, 0, 0}, {2 - depth, 0, 0}});
    for (int k = 0; k < 2; ++k)
    {
        pile.positionSolver.resolve(kDt);
        const auto& x = pile.running.position;
        EXPECT_LT(x[0].x(), -2 - 0.1 * depth) << k;
        EXPECT_GT(x[1].x() - x[0].x(), 2 - 0.05 * depth) << k;
        EXPECT_GT(x[2].x() - x[1].x(), 2 - 0.05 * depth) << k;
        pile.running.position[0] = {-2, 0, 0};
        pile.running.position[1] = {0, 0, 0};
        pile.running.position[2] = {2 - depth, 0, 0};
    }
}

// A sphere on another, a twentieth of a radius deep in it, slides over it: taking them apart lifts
// it, and its speed pays for that to the last bit of energy.
TEST(PositionSolver, ALiftCostsAsMuchSpeedAsItGivesHeight)
{
    Pile pile({{0, kFloor + 1, 0}, {0, kFloor + 2.95, 0}});
    pile.running.velocity[1] = {1, 0, 0.5};
    const double before = pile.energy();
    pile.positionSolver.resolve(kDt);
    EXPECT_GT(pile.running.position[1].y(), kFloor + 2.99);
    EXPECT_NEAR(pile.energy(), before, 1e-12);
    EXPECT_LT(pile.running.velocity[1].norm(), std::sqrt(1.25 - 2 * 0.04));
}

TEST(PositionSolver, SpheresPressedIntoARowClimbOutOfIt)
{
    // Nine along an edge of the floor that is eight long.
    std::vector<Eigen::Vector3d> places;
    places.reserve(9);
    for (int k = 0; k < 9; ++k)
    {
        places.emplace_back(-7 + 14.0 / 8 * k, kFloor + 1, -7);
    }
    Pile pile(places);
    for (int k = 0; k < 200; ++k)
    {
        pile.step();
    }
    for (std::uint32_t a = 0; a < 9; ++a)
    {
        for (std::uint32_t b = 0; b < a; ++b)
        {
            EXPECT_GT((pile.running.position[a] - pile.running.position[b]).norm(), 2 - 0.05);
        }
    }
}

// One that has crept into a wall is moved back. Those beside it are looked at on other threads, so
// they have to see it where it is afterwards, whoever comes first.
TEST(SupportIsland, LooksAtNobodyWhoIsStillBeingMoved)
{
    const std::vector<Eigen::Vector3d> places = {{7.01, kFloor + 1, 0}, {5.1, kFloor + 1, 0.5}};
    std::vector<std::vector<Eigen::Vector3d>> normals;
    for (const std::vector<std::uint32_t>& order : {std::vector{0U, 1U}, {1U, 0U}})
    {
        Pile pile(places);
        BroadPhase pairs(pile.running, pile.threads);
        pairs.findPairs();
        std::vector<std::uint32_t> members = order;
        SupportIsland(pile.running, pile.flight, pairs, pile.threads).keep(members);
        EXPECT_EQ(members, order);
        EXPECT_NEAR(pile.running.position[0].x(), 7, 1e-12);
        const Eigen::Vector3d way = pile.running.position[1] - pile.running.position[0];
        ASSERT_FALSE(pile.flight.normals(1).empty());
        EXPECT_EQ(pile.flight.normals(1).back(), way.normalized());
        normals.push_back(pile.flight.normals(1));
    }
    EXPECT_EQ(normals[0], normals[1]);
}

TEST(SupportIsland, AreThoseThatStandOnTheFloorAndOnEachOther)
{
    std::vector<Eigen::Vector3d> places = column(3);
    places.emplace_back(5, 0, 5);               // in the air
    places.emplace_back(5, 2, 5);               // on the one in the air
    places.emplace_back(-5, kFloor + 1, 5);     // alone on the floor
    places.emplace_back(-5, kFloor + 2.6, 3.8); // leans on it
    Pile pile(places);
    EXPECT_EQ(pile.carried(), (std::vector<std::uint32_t>{0, 1, 2, 5}));
}

TEST(Pile, OfAThousandSpheresFreezesWithoutOverlapsOrGaps)
{
    Scene scene = sceneOfPile();
    scene.spheres.count = 1000;
    std::vector<PlacedSphere> placed;
    for (int k = 0; k < 1000; ++k)
    {
        const auto shaken = [&](int at, std::uint64_t axis) {
            return -9 + 2.2 * at +
                   0.15 * (uniformRandom(3, static_cast<std::uint64_t>(k), axis) - 0.5);
        };
        placed.push_back({{shaken(k % 9, 0), shaken(k / 81, 1) - 5, shaken(k / 9 % 9, 2)}, 1});
    }
    std::string hash;
    for (const int threads : {1, 2})
    {
        scene.threads = threads;
        World world(scene, shapes::box({-10.5, -16, -10.5}, {10.5, 24, 10.5}, 16));
        const auto engine = makeEngine(world);
        engine->releaseAt(placed);
        while (engine->step())
        {
        }
        const QualityReport quality = examine(world);
        EXPECT_EQ(world.spheres.size(), 1000u);
        EXPECT_EQ(world.counts.overdue, 0u);
        EXPECT_LE(quality.maxOverlap, 1e-7);
        EXPECT_LE(quality.maxWallOverlap, 1e-6);
        EXPECT_EQ(quality.centresOutside, 0u);
        EXPECT_EQ(quality.unsupported, 0u);
        EXPECT_LE(quality.energyExcess, 1e-9);
        hash = hash.empty() ? hashState(world.spheres) : hash;
        EXPECT_EQ(hashState(world.spheres), hash);
    }
}

} // namespace
} // namespace frostfill

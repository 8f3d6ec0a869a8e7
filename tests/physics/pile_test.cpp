// SPDX-License-Identifier: MIT
// What runners do to one another: collisions, pushes, and who carries whom in a pile.

#include "base/random.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"
#include "simulation/solver/position_solver.hpp"
#include "simulation/solver/support_island.hpp"
#include "simulation/world/state_hash.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace frostfill
{
namespace
{

constexpr double kDt = 0.165;
constexpr double kFloor = -8;

Scene sceneOfPile()
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = 1;
    scene.threads = 1;
    return scene;
}

/// Runners in a box whose floor is at y = -8. Radii and gravity are 1.
struct Pile
{
    explicit Pile(const std::vector<Eigen::Vector3d>& places, const std::vector<double>& radii = {})
    {
        runners.resize(places.size());
        for (std::uint32_t k = 0; k < places.size(); ++k)
        {
            runners[k].restart(k, places[k], radii.empty() ? 1 : radii[k]);
        }
    }

    void step()
    {
        for (Runner& runner : runners)
        {
            flight.advance(runner, kDt);
        }
        positionSolver.resolve(runners, kDt);
    }

    [[nodiscard]] double energy() const
    {
        return std::accumulate(
            runners.begin(), runners.end(), 0.0,
            [](double sum, const Runner& runner)
            { return sum + runner.velocity.squaredNorm() / 2 + runner.position.y(); });
    }

    /// Those that carry one another, of all.
    std::vector<std::uint32_t> carried()
    {
        step(); // finds who meets whom
        std::vector<std::uint32_t> members(runners.size());
        std::iota(members.begin(), members.end(), 0);
        for (Runner& runner : runners)
        {
            runner.member = true;
        }
        SupportIsland(flight, threads).keep(runners, members);
        return members;
    }

    World world{sceneOfPile(), shapes::box({-8, -8, -8}, {8, 8, 8}, 8)};
    FreeFlight flight{world, {}};
    Threads threads{1};
    RunnerGrid grid{world.resting.frame()};
    PositionSolver positionSolver{grid, flight, threads, {}};
    std::vector<Runner> runners;
};

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
        for (const Runner& runner : pile.runners)
        {
            EXPECT_LT(runner.velocity.norm(), 1e-3);
            EXPECT_NEAR(runner.position.y(), kFloor + 1 + 2 * runner.id, 2e-3);
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
        for (Runner& runner : pile.runners)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                runner.velocity[axis] =
                    6 * (uniformRandom(seed, runner.id, 3 + static_cast<std::uint64_t>(axis)) - .5);
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
        for (const Runner& runner : pile.runners)
        {
            EXPECT_LT(runner.velocity.norm(), 0.5);
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
        Runner& heavy = pile.runners[0];
        Runner& light = pile.runners[1];
        heavy.velocity = 0.7 * normal + Eigen::Vector3d(0, 0.3, 0);
        light.velocity = -1.1 * normal;
        pile.positionSolver.resolve(pile.runners, kDt);
        const double mass = small * small * small;
        const double common = (0.7 - mass * 1.1) / (1 + mass); // of the centre of mass
        const double parting = SolverSettings().restitution * 1.8;
        EXPECT_NEAR(heavy.velocity.dot(normal), common - parting * mass / (1 + mass), 1e-12);
        EXPECT_NEAR(light.velocity.dot(normal), common + parting / (1 + mass), 1e-12);
        EXPECT_NEAR(heavy.velocity.y(), 0.3, 1e-12);
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
        { return (pile.runners[0].position + mass * pile.runners[1].position).eval(); };
        const Eigen::Vector3d before = middle();
        pile.positionSolver.resolve(pile.runners, kDt);
        EXPECT_NEAR((pile.runners[1].position - pile.runners[0].position).norm(), 1 + small, 1e-12);
        EXPECT_LT((middle() - before).norm(), 1e-12) << small;
    }
}

// A sphere on another, a twentieth of a radius deep in it, slides over it: taking them apart lifts
// it, and its speed pays for that to the last bit of energy.
TEST(PositionSolver, ALiftCostsAsMuchSpeedAsItGivesHeight)
{
    Pile pile({{0, kFloor + 1, 0}, {0, kFloor + 2.95, 0}});
    pile.runners[1].velocity = {1, 0, 0.5};
    const double before = pile.energy();
    pile.positionSolver.resolve(pile.runners, kDt);
    EXPECT_GT(pile.runners[1].position.y(), kFloor + 2.99);
    EXPECT_NEAR(pile.energy(), before, 1e-12);
    EXPECT_LT(pile.runners[1].velocity.norm(), std::sqrt(1.25 - 2 * 0.04));
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
    for (const Runner& a : pile.runners)
    {
        for (const Runner& b : pile.runners)
        {
            if (a.id < b.id)
            {
                EXPECT_GT((a.position - b.position).norm(), 2 - 0.05);
            }
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
        for (std::uint32_t k = 0; k < 2; ++k)
        {
            pile.runners[k].nearby = {1 - k};
            pile.runners[k].member = true;
        }
        std::vector<std::uint32_t> members = order;
        SupportIsland(pile.flight, pile.threads).keep(pile.runners, members);
        EXPECT_EQ(members, order);
        EXPECT_NEAR(pile.runners[0].position.x(), 7, 1e-12);
        const Eigen::Vector3d way = pile.runners[1].position - pile.runners[0].position;
        ASSERT_FALSE(pile.runners[1].normals.empty());
        EXPECT_EQ(pile.runners[1].normals.back(), way.normalized());
        normals.push_back(pile.runners[1].normals);
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
        EXPECT_EQ(world.overdue, 0u);
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

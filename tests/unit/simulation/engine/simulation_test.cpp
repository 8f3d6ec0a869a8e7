// SPDX-License-Identifier: MIT
#include "support/shapes.hpp"
#include "unit/simulation/engine/small_torus.hpp"

#include <frostfill/error.hpp>
#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace frostfill
{
namespace
{

using test::runToEnd;
using test::smallTorus;

std::string finalHash(const Scene& scene)
{
    Simulation simulation(scene, shapes::torus());
    runToEnd(simulation);
    return simulation.stateHash();
}

std::uint64_t pairs(std::uint64_t n)
{
    return n * (n - std::min<std::uint64_t>(n, 1)) / 2;
}

// PAPER, operation counts: R running, K frozen and not discarded, m' polygons not discarded.
void expectClosedFormAtEveryStep(const Scene& scene)
{
    const TriangleMesh mesh = shapes::torus();
    Simulation simulation(scene, mesh);
    Snapshot snapshot;
    OperationCounts before;
    while (simulation.step())
    {
        simulation.capture(snapshot);
        const OperationCounts made = simulation.operations() - before;
        before = simulation.operations();
        const std::uint64_t running = snapshot.running;
        const std::uint64_t polygons = mesh.triangles.size() - snapshot.discardedPolygons;
        ASSERT_EQ(made.runningRunningTests, pairs(running));
        ASSERT_EQ(made.runningFrozenTests, running * snapshot.frozen);
        ASSERT_EQ(made.spherePolygonTests, running * polygons);
        ASSERT_LE(made.runningRunningResponses, 2 * made.runningRunningTests);
        ASSERT_LE(made.runningFrozenResponses, made.runningFrozenTests);
        ASSERT_LE(made.spherePolygonResponses, made.spherePolygonTests);
    }
    EXPECT_EQ(simulation.sphereCount(), 80u);
}

TEST(Simulation, TestsEqualTheClosedFormAtEveryStepWithoutDiscards)
{
    Scene scene = smallTorus();
    scene.discard.rule = DiscardRule::none;
    expectClosedFormAtEveryStep(scene);
}

TEST(Simulation, TestsEqualTheClosedFormAtEveryStepWithDiscards)
{
    Scene scene = smallTorus();
    scene.discard.rule = DiscardRule::paper;
    expectClosedFormAtEveryStep(scene);
}

// PAPER, Lemmas 1 and 2: with a freeze after every set, the last set makes (beta/k - 1)(k gamma)^2
// + k gamma (k gamma - 1) / 2 sphere-sphere tests a step. Lemma 1 is the case k = 1.
void expectLemmaInEveryStep(std::uint32_t groupSize, std::uint32_t groupsPerSet)
{
    Scene scene = smallTorus();
    scene.discard.rule = DiscardRule::none;
    scene.freezing.everySets = 1;
    scene.spheres.groupSize = groupSize;
    scene.spheres.groupsPerSet = groupsPerSet;
    Simulation simulation(scene, shapes::torus());
    const std::uint64_t inSet = std::uint64_t{groupSize} * groupsPerSet;
    OperationCounts before;
    while (simulation.step())
    {
        const OperationCounts made = simulation.operations() - before;
        before = simulation.operations();
        const std::uint64_t beta = simulation.sphereCount() / groupSize;
        const std::uint64_t earlierSets = beta / groupsPerSet - 1;
        ASSERT_EQ(made.runningRunningTests + made.runningFrozenTests,
                  earlierSets * inSet * inSet + pairs(inSet));
        ASSERT_LE(made.runningRunningResponses + made.runningFrozenResponses,
                  earlierSets * inSet * inSet + inSet * (inSet - 1));
    }
}

TEST(Simulation, OneGroupASetMakesTheTestsOfLemma1)
{
    expectLemmaInEveryStep(10, 1);
}
TEST(Simulation, SeveralGroupsASetMakeTheTestsOfLemma2)
{
    expectLemmaInEveryStep(5, 4);
}

// PAPER, Lemma 3: over one step of each set the polygon tests add up to n m at the most.
TEST(Simulation, PolygonTestsOfOneStepASetMatchLemma3)
{
    Scene scene = smallTorus();
    scene.freezing.everySets = 1;
    const TriangleMesh mesh = shapes::torus();
    Simulation simulation(scene, mesh);
    std::uint64_t measured = 0;
    std::uint64_t predicted = 0;
    std::size_t setsSeen = 0;
    std::uint64_t before = 0;
    Snapshot snapshot;
    while (simulation.step())
    {
        const std::uint64_t made = simulation.operations().spherePolygonTests - before;
        before = simulation.operations().spherePolygonTests;
        if (simulation.sets().size() > setsSeen)
        {
            setsSeen = simulation.sets().size();
            simulation.capture(snapshot);
            measured += made;
            predicted += 20 * (mesh.triangles.size() - snapshot.discardedPolygons);
        }
    }
    EXPECT_EQ(setsSeen, 4u);
    EXPECT_EQ(measured, predicted);
    EXPECT_LE(measured, 80 * mesh.triangles.size());
}

TEST(Simulation, EqualScenesGiveEqualBits)
{
    EXPECT_EQ(finalHash(smallTorus()), finalHash(smallTorus()));
}

TEST(Simulation, SeedsGiveDifferentResults)
{
    Scene other = smallTorus();
    other.seed = 2;
    EXPECT_NE(finalHash(smallTorus()), finalHash(other));
}

TEST(Simulation, PolygonSearchesAgreeToTheBit)
{
    Scene list = smallTorus();
    list.search.polygons = PolygonSearch::list;
    Scene quadtree = smallTorus();
    quadtree.search.polygons = PolygonSearch::quadtree;
    const std::string loop = finalHash(smallTorus());
    EXPECT_EQ(finalHash(list), loop);
    EXPECT_EQ(finalHash(quadtree), loop);
}

TEST(Simulation, GridsAgreeWithAllPairsToTheBitAndTestFewer)
{
    const TriangleMesh mesh = shapes::torus();
    for (const std::uint64_t seed : {1, 2, 3})
    {
        Scene pairsScene = smallTorus();
        pairsScene.seed = seed;
        Scene gridScene = pairsScene;
        gridScene.search = {SphereSearch::grid, PolygonSearch::grid};
        Simulation allPairs(pairsScene, mesh);
        Simulation grid(gridScene, mesh);
        runToEnd(allPairs);
        runToEnd(grid);
        EXPECT_EQ(grid.stateHash(), allPairs.stateHash()) << seed;
        const OperationCounts& few = grid.operations();
        const OperationCounts& many = allPairs.operations();
        EXPECT_EQ(few.responses(), many.responses());
        EXPECT_EQ(few.runningRunningTests, many.runningRunningTests);
        EXPECT_LT(few.runningFrozenTests, many.runningFrozenTests / 2);
        EXPECT_LT(few.spherePolygonTests, many.spherePolygonTests / 2);
        // A response is a test that found a contact.
        EXPECT_GE(few.runningFrozenTests, few.runningFrozenResponses);
        EXPECT_GE(few.spherePolygonTests, few.spherePolygonResponses);
    }
}

TEST(Simulation, ScaleByAPowerOfTwoChangesNoBit)
{
    Scene scaled = smallTorus();
    scaled.spheres.radius = 8 * scaled.spheres.radius->largest;
    scaled.object.unitsPerMetre = 8;
    Simulation large(scaled, shapes::torus(8, 3.2));
    runToEnd(large);
    EXPECT_EQ(large.stateHash(), finalHash(smallTorus()));
}

TEST(Simulation, ReleasedSpheresOverlapNothing)
{
    Simulation simulation(smallTorus(), shapes::torus());
    std::size_t known = 0;
    while (simulation.step())
    {
        // A step moves a sphere that has just appeared by nothing (explicit Euler, no speed).
        for (std::size_t i = known; i < simulation.sphereCount(); ++i)
        {
            for (std::size_t j = 0; j < i; ++j)
            {
                const double distance =
                    (simulation.sphere(i).centre - simulation.sphere(j).centre).norm();
                ASSERT_GE(distance, 2 * simulation.radius() * (1 - 1e-12)) << i << " and " << j;
            }
        }
        known = simulation.sphereCount();
    }
}

TEST(Simulation, FillsUntilFullAndSaysSo)
{
    Scene scene = smallTorus();
    scene.spheres.count.reset();
    Simulation simulation(scene, shapes::torus());
    runToEnd(simulation);
    EXPECT_TRUE(simulation.full());
    EXPECT_EQ(simulation.restingCount(), simulation.sphereCount());
    const QualityReport quality = simulation.quality();
    EXPECT_GT(quality.sphereVolume / quality.meshVolume, 0.35);
    EXPECT_EQ(quality.centresOutside, 0u);
    EXPECT_EQ(quality.notFinite, 0u);
}

TEST(Simulation, StopsAtTheCount)
{
    Simulation simulation(smallTorus(), shapes::torus());
    runToEnd(simulation);
    EXPECT_TRUE(simulation.finished());
    EXPECT_FALSE(simulation.full());
    EXPECT_EQ(simulation.sphereCount(), 80u);
    EXPECT_FALSE(simulation.step());
    EXPECT_EQ(simulation.sets().size(), 4u);
}

TEST(Simulation, RefusesAnObjectIntoWhichNoSphereFits)
{
    Scene scene = smallTorus();
    scene.spheres.radius = 0.45;
    try
    {
        Simulation simulation(scene, shapes::torus());
        FAIL() << "a sphere of 0.45 cannot fit into a tube of 0.4";
    }
    catch (const Error& error)
    {
        EXPECT_EQ(error.code(), ErrorCode::badData);
        // The largest radius inside, and one for the 80 spheres.
        EXPECT_NE(std::string(error.what()).find("room for a radius of 0.3"), std::string::npos)
            << error.what();
        EXPECT_NE(std::string(error.what()).find("80 of radius 0.1"), std::string::npos)
            << error.what();
    }
}

TEST(Simulation, FillsThinWallsToTheCountAtTheDefault)
{
    const TriangleMesh plate = shapes::box({0, 0, 0}, {12, 1, 12});
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        Scene scene = presetScene(Preset::fast, "plate");
        scene.spheres.count = 100;
        scene.motion.mode = motion;
        Simulation simulation(scene, plate);
        runToEnd(simulation);
        EXPECT_EQ(simulation.sphereCount(), 100u);
        EXPECT_GT(simulation.radius(), 0.3);
    }
}

TEST(Simulation, NamesARadiusWithWhichTheCountFitsWhenItIsFullBefore)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.motion.mode = Motion::skip;
    for (const double radius : {0.2, 0.3, 0.38})
    {
        scene.spheres.radius = radius;
        scene.spheres.count = 150;
        Simulation tooLarge(scene, shapes::torus());
        runToEnd(tooLarge);
        ASSERT_TRUE(tooLarge.full());
        ASSERT_LT(tooLarge.sphereCount(), 150u);
        scene.spheres.radius = tooLarge.radiusThatFits(150);
        EXPECT_GT(scene.spheres.radius->largest, 0.09);
        Simulation asNamed(scene, shapes::torus());
        runToEnd(asNamed);
        EXPECT_EQ(asNamed.sphereCount(), 150u) << radius;
    }
}

TEST(Simulation, FillsPartsThatLieFarApart)
{
    TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 1, 1});
    const TriangleMesh other = shapes::box({3000, 2000, 0}, {3001, 2001, 1});
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles)
    {
        mesh.triangles.push_back({a + first, b + first, c + first});
    }
    Scene scene = presetScene(Preset::fast, "parts");
    scene.spheres.count = 60;
    scene.motion.mode = Motion::skip;
    Simulation simulation(scene, mesh);
    runToEnd(simulation);
    EXPECT_EQ(simulation.sphereCount(), 60u);
    std::size_t far = 0;
    Snapshot snapshot;
    simulation.capture(snapshot);
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        const Eigen::Vector3d p = simulation.sphere(id).centre;
        far += p.x() > 1000 ? 1 : 0;
        const Eigen::Vector3d inPart =
            p.x() > 1000 ? Eigen::Vector3d(p - Eigen::Vector3d(3000, 2000, 0)) : p;
        EXPECT_TRUE((inPart.array() > 0).all() && (inPart.array() < 1).all()) << p.transpose();
        EXPECT_NEAR((snapshot.origin + snapshot.centres[id].cast<double>() - p).norm(), 0, 1e-3);
    }
    EXPECT_GT(far, 20u);
    EXPECT_LT(far, 40u);
    EXPECT_EQ(simulation.quality().centresOutside, 0u);
}

// Collisions that lose nothing never come to rest.
TEST(Simulation, EndsASetAtItsTimeLimitAndSaysSo)
{
    for (const double restitution : {1.0, 0.3})
    {
        Scene scene = smallTorus();
        scene.spheres.count = 20;
        scene.motion.restitution = restitution;
        scene.freezing.setTimeLimit = restitution < 1 ? 60 : 1e-3;
        Simulation simulation(scene, shapes::torus());
        runToEnd(simulation);
        ASSERT_FALSE(simulation.sets().empty());
        EXPECT_EQ(simulation.sets().front().timedOut, restitution == 1);
    }
}

TEST(Simulation, StatesFollowTheOrderOfAppearance)
{
    Simulation simulation(smallTorus(), shapes::torus());
    Snapshot snapshot;
    while (simulation.step())
    {
        simulation.capture(snapshot);
        const auto order = [](SphereState a, SphereState b)
        { return static_cast<int>(a) > static_cast<int>(b); };
        ASSERT_TRUE(std::is_sorted(snapshot.states.begin(), snapshot.states.end(), order));
    }
}

} // namespace
} // namespace frostfill

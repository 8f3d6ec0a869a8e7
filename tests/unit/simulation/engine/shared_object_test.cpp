// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "simulation/world/world.hpp"
#include "support/expect_error.hpp"
#include "support/shapes.hpp"
#include "unit/simulation/engine/small_torus.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <numeric>
#include <optional>
#include <vector>

namespace frostfill
{
namespace
{

using test::runToEnd;

TEST(SharedObject, GivesARunTheBitsThatOneOfItsOwnDoes)
{
    const TriangleMesh mesh = shapes::torus();
    for (const Motion motion : {Motion::fall, Motion::skip, Motion::descend})
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.spheres.count = 60;
        scene.motion.mode = motion;
        std::optional<Simulation> first(std::in_place, scene, mesh);
        runToEnd(*first);
        Scene other = scene;
        other.discard.rule = DiscardRule::none;
        other.seed = 7;
        Simulation second(other, *first);
        first.reset(); // what they shared stays
        runToEnd(second);
        Simulation alone(other, mesh);
        runToEnd(alone);
        EXPECT_EQ(second.stateHash(), alone.stateHash());
        EXPECT_EQ(second.object().volume, alone.object().volume);
    }
}

TEST(SharedObject, OfAThinPlateFindsItsNearestTriangleWhateverAxisIsUp)
{
    const TriangleMesh plate = shapes::box({100, 0, 0}, {120, 20, 1}, 8);
    for (const Axis up : {Axis::x, Axis::y, Axis::z})
    {
        Scene scene = presetScene(Preset::fast, "plate");
        scene.spheres.count = 100;
        scene.object.up = up;
        const ObjectOfRun object(scene, plate);
        std::vector<std::uint32_t> all(object.surface.size());
        std::iota(all.begin(), all.end(), 0U);
        std::uint64_t draws = 0;
        const auto draw = [&] { return 30 * uniformRandom(2, 0, draws++) - 15; };
        for (int k = 0; k < 100; ++k)
        {
            const Eigen::Vector3d p(draw(), draw(), draw());
            EXPECT_EQ(nearestDistance(object.surface, p, 100).value,
                      nearestDistance(object.surface, all, p).value);
        }
    }
}

TEST(SharedObject, OfALoadedMeshIsThatOfItsTriangles)
{
    TriangleMesh two = shapes::box({0, 0, 0}, {2, 2, 2});
    const TriangleMesh other = shapes::box({1, 1, 1}, {3, 3, 3}); // they pass through each other
    for (const auto& [a, b, c] : other.triangles)
    {
        const auto first = static_cast<std::uint32_t>(two.vertices.size());
        two.vertices.insert(two.vertices.end(),
                            {other.vertices[a], other.vertices[b], other.vertices[c]});
        two.triangles.push_back({first, first + 1, first + 2});
    }
    for (const TriangleMesh& mesh : {shapes::torus(), two})
    {
        Scene scene = presetScene(Preset::fast, "torus");
        scene.spheres.count = 40;
        const LoadedMesh loaded = repairMesh(mesh, "mesh");
        LoadedMesh withoutReport = loaded;
        withoutReport.report = {};
        Simulation expected(scene, loaded.mesh);
        runToEnd(expected);
        for (const LoadedMesh& given : {loaded, withoutReport})
        {
            Simulation simulation(scene, given);
            runToEnd(simulation);
            EXPECT_EQ(simulation.stateHash(), expected.stateHash());
            EXPECT_EQ(simulation.object().volume, expected.object().volume);
            EXPECT_EQ(simulation.object().area, expected.object().area);
            EXPECT_EQ(simulation.object().components, expected.object().components);
            EXPECT_EQ(simulation.object().crossedTriangles, expected.object().crossedTriangles);
        }
    }
}

TEST(SharedObject, IsRefusedToASceneThatNeedsAnother)
{
    Scene scene = presetScene(Preset::fast, "torus");
    scene.spheres.radius = 0.13;
    const Simulation simulation(scene, shapes::torus());
    const auto refuses = [&](auto&& change)
    {
        Scene other = scene;
        change(other);
        test::expectError(
            ErrorCode::usage, [&] { const Simulation shared(other, simulation); }, "share");
    };
    refuses([](Scene& other) { other.object.mesh = "cube"; });
    refuses([](Scene& other) { other.object.up = Axis::z; });
    refuses([](Scene& other) { other.spheres.radius = 0.01; });
    refuses([](Scene& other) { other.spheres.count = 3; });
    refuses([](Scene& other) { other.motion.gravity = 1; });
    refuses([](Scene& other) { other.move.tilt = 10; });
}

} // namespace
} // namespace frostfill

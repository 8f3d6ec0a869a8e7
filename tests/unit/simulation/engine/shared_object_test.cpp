// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/shapes.hpp"
#include "unit/simulation/engine/small_torus.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <optional>

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

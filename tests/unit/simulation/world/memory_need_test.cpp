// SPDX-License-Identifier: MIT
#include "simulation/world/memory_need.hpp"

#include "base/memory_at_hand.hpp"
#include "support/expect_error.hpp"
#include "support/shapes.hpp"

#include <frostfill/error.hpp>
#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

TEST(MemoryNeed, IsThatOfAMillionSpheresToWithinAFactorOfTwo)
{
    const double need = memoryNeed(1e6); // measured: 171 MB with discards
    EXPECT_GT(need, 85e6);
    EXPECT_LT(need, 171e6);
}

TEST(MemoryNeed, IsRefusedBeforeAnythingIsSetAside)
{
    const TriangleMesh mesh = shapes::box({-1, -1, -1}, {1, 1, 1});
    for (const double radius : {1e-5, 1e-10, 1e-12})
    {
        Scene scene = presetScene(Preset::fast, "cube");
        scene.spheres.radius = radius;
        scene.spheres.count.reset();
        test::expectError(
            ErrorCode::outOfMemory, [&] { (void)Simulation(scene, mesh); }, "memory", "--radius");
        scene.spheres.count = 20; // a small heap in a grid without end
        test::expectError(
            ErrorCode::badData, [&] { (void)Simulation(scene, mesh); }, "too large", "--radius");
    }
}

TEST(MemoryNeed, NamesARadiusThatIsLargeEnough)
{
    const MeshReport cube = inspectMesh(shapes::box({-1, -1, -1}, {1, 1, 1}));
    const Scene scene = presetScene(Preset::fast, "cube");
    EXPECT_NO_THROW(requireMemory(scene, cube, 0.1, 1000, 1e6));
    test::expectError(
        ErrorCode::outOfMemory, [&] { requireMemory(scene, cube, 0.001, 1e9, 1e9); },
        "--radius of 0.011 or more", "1 GB");
    EXPECT_NO_THROW(requireMemory(scene, cube, 0.011, 8 / std::pow(0.011, 3), 1e9));
    EXPECT_GT(memoryAtHand(), 1e8);
}

} // namespace
} // namespace frostfill

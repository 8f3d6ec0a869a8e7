// SPDX-License-Identifier: MIT
#include "base/resources.hpp"
#include "simulation/world/world.hpp"
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

TEST(MemoryNeed, IsAtMostWhatRunsTakeAndAtLeastHalf)
{
    // Cubes by their width in radii; measured with `frostfill fill cube --count N --motion descend
    // --frames none`, the first two with --until-full.
    struct Measured
    {
        double spheres, width, bytes;
    };
    for (const Measured& run : {Measured{1097069, 200, 144e6}, Measured{10977704, 431, 1.10e9},
                                Measured{1e8, 928, 7.35e9}})
    {
        const double w = run.width;
        const double need = memoryNeed(ObjectSize(shapes::box({0, 0, 0}, {w, w, w})), run.spheres);
        EXPECT_GT(need, 0.5 * run.bytes) << run.spheres;
        EXPECT_LT(need, run.bytes) << run.spheres;
    }
}

TEST(MemoryNeed, CountsTheGridsOfAFewSpheresInALargeObject)
{
    // Measured: 334 MB above what the program takes.
    const double cube = memoryNeed(ObjectSize(shapes::box({0, 0, 0}, {377, 377, 377})), 10);
    EXPECT_GT(cube, 250e6);
    EXPECT_LT(cube, 334e6);
    // A long bar, wherever its box ends.
    const double bar = memoryNeed(ObjectSize(shapes::box({0, 0, 0}, {1e6, 6, 6})), 10);
    EXPECT_GT(bar, 1e9);
    EXPECT_LT(bar, 3e9);
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
    EXPECT_NO_THROW(requireMemory(scene, cube, 0.1, 1000, {1e6}));
    test::expectError(
        ErrorCode::outOfMemory, [&] { requireMemory(scene, cube, 0.001, 1e9, {1e9}); },
        "--radius of 0.0078 or more", "1 GB");
    EXPECT_NO_THROW(requireMemory(scene, cube, 0.0078, 8 / std::pow(0.0078, 3), {1e9}));
    test::expectError(
        ErrorCode::outOfMemory, [&] { requireMemory(scene, cube, 0.0023, 20, {1e9}); },
        "--radius of 0.0078 or more");
    test::expectError(
        ErrorCode::outOfMemory,
        [&] {
            requireMemory(scene, cube, 0.0023, 20, {1e9, "that the group leaves"});
        },
        "more than the 1 GB of memory that the group leaves; take a --radius");
    test::expectError(
        ErrorCode::outOfMemory, [&] { requireMemory(scene, cube, 0.003, 20, {0}); },
        "more than the 0 GB of memory here");
    EXPECT_GT(memoryAtHand().bytes, 1e8);
}

} // namespace
} // namespace frostfill

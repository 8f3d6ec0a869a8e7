// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <frostfill/scene.hpp>

#include <cmath>

namespace frostfill
{
namespace
{

TEST(Presets, AreThePapersForItsObjects)
{
    const Scene torus = presetScene(Preset::paper, "torus");
    EXPECT_EQ(torus.spheres.count, 320u);
    EXPECT_EQ(torus.spheres.groupSize, 10u);
    EXPECT_EQ(torus.spheres.groupsPerSet, 2u);
    EXPECT_EQ(torus.freezing.everySets, 2u);

    const Scene cube = presetScene(Preset::paper, "cube");
    EXPECT_EQ(cube.spheres.groupSize, 3u);
    EXPECT_EQ(cube.spheres.groupsPerSet, 7u);
    EXPECT_EQ(*cube.spheres.count % 21, 0u);

    const Scene human = presetScene(Preset::paper, "human");
    EXPECT_EQ(human.spheres.groupSize, 3u);
    EXPECT_EQ(human.spheres.groupsPerSet, 2u);
    EXPECT_EQ(human.freezing.everySets, 3u);
}

TEST(Presets, NameARunAfterItsMesh)
{
    EXPECT_EQ(presetScene(Preset::paper, "torus").name, "torus");
    EXPECT_EQ(presetScene(Preset::paper, "some/where/bunny.fine.obj").name, "bunny.fine");
    EXPECT_FALSE(presetScene(Preset::paper, "some/where/").name.empty());
}

TEST(Gravity, IsInUnitsOfTheMesh)
{
    Scene scene;
    scene.object.unitsPerMetre = 1000;
    EXPECT_DOUBLE_EQ(gravityInMeshUnits(scene), 9810);
    EXPECT_EQ(upVector(Axis::z), Eigen::Vector3d::UnitZ());
}

TEST(SphereRadius, SolvesTheEstimateForTheCount)
{
    MeshReport sphere;
    sphere.volume = 4.0 / 3.0 * M_PI;
    sphere.area = 4 * M_PI;
    for (const std::uint64_t count : {1u, 10u, 320u, 1000000u})
    {
        Scene scene;
        scene.spheres.count = count;
        const double r = sphereRadius(scene, sphere);
        const double wanted = static_cast<double>(count) * 4.0 / 3.0 * M_PI * r * r * r;
        EXPECT_NEAR(wanted, 0.9 * 0.586 * (sphere.volume - 0.38 * r * sphere.area), 1e-12);
        EXPECT_GT(r, 0);
    }
}

TEST(SphereRadius, IsTheScenesOwnWhenGiven)
{
    Scene scene;
    scene.spheres.radius = 0.125;
    scene.spheres.count = 7;
    EXPECT_EQ(sphereRadius(scene, {}), 0.125);
    scene.spheres.radius.reset();
    scene.spheres.count.reset();
    test::expectError(
        ErrorCode::usage, [&] { (void)sphereRadius(scene, {}); }, "radius", "count");
}

} // namespace
} // namespace frostfill

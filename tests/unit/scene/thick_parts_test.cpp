// SPDX-License-Identifier: MIT
#include "scene/thick_parts.hpp"

#include "support/shapes.hpp"

#include <frostfill/scene.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

Scene sceneOf(std::uint64_t count)
{
    Scene scene;
    scene.spheres.count = count;
    return scene;
}

double radiusFor(const TriangleMesh& mesh, std::uint64_t count)
{
    return sphereRadius(sceneOf(count), inspectInterior(mesh), mesh);
}

double compactRadiusFor(const TriangleMesh& mesh, std::uint64_t count)
{
    return sphereRadius(sceneOf(count), inspectInterior(mesh));
}

/// A cube of edge 2 on a wide plate.
TriangleMesh cubeOnPlate(double thickness)
{
    const std::vector<double> planes = {-10, -1, 1, 10};
    return shapes::gridCells({planes, {0, thickness, 2}, planes}, [](const std::array<int, 3>& cell)
                             { return cell[1] == 0 || (cell[0] == 1 && cell[2] == 1); });
}

TEST(ThickParts, OfACompactObjectGiveTheRadiusOfTheWholeObject)
{
    for (const std::string& name : builtInMeshNames())
    {
        const TriangleMesh mesh = builtInMesh(name);
        for (const std::uint64_t count : {100u, 300u, 3000u})
        {
            EXPECT_EQ(radiusFor(mesh, count), compactRadiusFor(mesh, count)) << name << count;
            const ThickParts parts(inspectInterior(mesh), mesh, TriangleBvh(mesh), 1000);
            EXPECT_NEAR(parts.radius(static_cast<double>(count) / 0.9) /
                            compactRadiusFor(mesh, count),
                        1, 0.01);
        }
    }
}

TEST(ThickParts, OfAPlateTakeNoSphereThatIsThicker)
{
    const TriangleMesh plate = shapes::box({0, 0, 0}, {20, 20, 1});
    EXPECT_GT(compactRadiusFor(plate, 50), 0.5) << "or this test shows nothing";
    EXPECT_LT(radiusFor(plate, 50), 0.5);
    EXPECT_GT(radiusFor(plate, 50), 0.45);
    const ThickParts parts(inspectInterior(plate), plate, TriangleBvh(plate), 1000);
    EXPECT_NEAR(parts.largest(), 0.5, 1e-4);
    EXPECT_EQ(parts.count(0.51), 0);
}

TEST(ThickParts, AreAllThatCountsForLargeSpheres)
{
    const TriangleMesh mesh = cubeOnPlate(0.2);
    const ThickParts parts(inspectInterior(mesh), mesh, TriangleBvh(mesh), 4000);
    const TriangleMesh cube = shapes::box({-1, 0, -1}, {1, 2, 1});
    const double inCube = 0.586 * (8 - 0.38 * 0.2 * 24) / (4.0 / 3.0 * M_PI * std::pow(0.2, 3));
    EXPECT_NEAR(parts.count(0.2) / inCube, 1, 0.15);
    EXPECT_GT(parts.count(0.09), 8 * inCube) << "the plate, too";
}

TEST(ThickParts, CountTheRadiusThatTheyGive)
{
    const TriangleMesh mesh = cubeOnPlate(0.5);
    const ThickParts parts(inspectInterior(mesh), mesh, TriangleBvh(mesh), 1000);
    for (const double count : {20.0, 500.0, 30000.0})
    {
        EXPECT_GE(parts.count(parts.radius(count)), count);
        EXPECT_LT(parts.count(1.01 * parts.radius(count)), count);
    }
    const RelativeRadii half{0.5, 0.125};
    EXPECT_GT(parts.radius(30000, half), 1.5 * parts.radius(30000)) << "most spheres are smaller";
}

} // namespace
} // namespace frostfill

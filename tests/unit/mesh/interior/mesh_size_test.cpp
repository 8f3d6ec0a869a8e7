// SPDX-License-Identifier: MIT
#include "unit/mesh/mesh_samples.hpp"

#include <cmath>

namespace frostfill
{
namespace
{

TEST(SignedVolume, OfTheCubeIsExact)
{
    EXPECT_EQ(signedVolume(builtInMesh("cube")), 8.0);
    EXPECT_EQ(signedVolume(test::box(1.0, 3.0)), 8.0);
}

TEST(SignedVolume, IsNegativeForAMeshWoundInwards)
{
    TriangleMesh mesh = test::box(0, 1);
    test::flipAll(mesh);
    EXPECT_EQ(signedVolume(mesh), -1.0);
}

// The ring of regular 12-gons, cut into 48 wedges that are each bounded by plane quads or by two
// triangles: V = n/2 sin(2 pi/n) times the n-gon's first moment; the triangles' twist cancels only
// in the limit, so the polyhedron is compared with the smooth torus and its known rate.
TEST(SignedVolume, OfTheTorusTendsToTheSmoothOne)
{
    const double smooth = 2 * M_PI * M_PI * 1.0 * 0.4 * 0.4;
    // An inscribed n-gon has sin(2 pi/n) / (2 pi/n) of its circle's area.
    const double across = std::sin(2 * M_PI / 12) / (2 * M_PI / 12);
    const double around = std::sin(2 * M_PI / 48) / (2 * M_PI / 48);
    EXPECT_NEAR(signedVolume(builtInMesh("torus")), smooth * across * around, 2e-3 * smooth);
}

// The rings of a sphere of latitude and longitude are frusta of regular 32-gons, whose quads are
// plane: V = sum of h/3 (A1 + A2 + sqrt(A1 A2)).
TEST(SignedVolume, OfTheSphereIsThatOfItsFrusta)
{
    const double polygon = 16 * std::sin(2 * M_PI / 32); // area over circumradius squared
    double volume = 0;
    for (int ring = 0; ring < 16; ++ring)
    {
        const double upper = M_PI * ring / 16, lower = M_PI * (ring + 1) / 16;
        const double r1 = std::sin(upper), r2 = std::sin(lower);
        volume += polygon * (r1 * r1 + r2 * r2 + r1 * r2) * (std::cos(upper) - std::cos(lower)) / 3;
    }
    EXPECT_NEAR(signedVolume(builtInMesh("sphere")), volume, 1e-8);
}

TEST(SignedVolume, KeepsItsDigitsFarFromTheOrigin)
{
    EXPECT_EQ(signedVolume(test::box(1e6, 1e6 + 0.5)), 0.125);
    const double low = 1e6 / 3; // not a round number, whose products are exact
    const double high = low + 0.1;
    EXPECT_NEAR(signedVolume(test::box(low, high)), std::pow(high - low, 3), 1e-15);
}

TEST(SurfaceArea, OfTheCubeIsExact)
{
    EXPECT_DOUBLE_EQ(surfaceArea(builtInMesh("cube")), 24.0);
}

TEST(SurfaceArea, OfTheSphereIsJustBelowTheSmoothOne)
{
    const double area = surfaceArea(builtInMesh("sphere"));
    EXPECT_LT(area, 4 * M_PI);
    EXPECT_GT(area, 0.99 * 4 * M_PI);
}

TEST(BoundingBox, HoldsUsedVerticesOnly)
{
    TriangleMesh mesh = test::box(-1, 2);
    mesh.vertices.emplace_back(100, 100, 100);
    EXPECT_EQ(boundingBox(mesh).max(), Eigen::Vector3d(2, 2, 2));
    EXPECT_EQ(boundingBox(mesh).min(), Eigen::Vector3d(-1, -1, -1));
}

} // namespace
} // namespace frostfill

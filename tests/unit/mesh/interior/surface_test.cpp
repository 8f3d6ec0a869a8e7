// SPDX-License-Identifier: MIT
#include "mesh/interior/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

/// Two triangles with a common edge, the second of which is turned about it.
Surface hinge(double angle)
{
    const Eigen::Vector3d middle(0.5, 0.5, 0);
    const Eigen::Vector3d out = Eigen::Vector3d(1, 1, 0) / 2;
    const Eigen::Vector3d up(0, 0, out.norm());
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.vertices.emplace_back(middle + std::cos(angle) * out + std::sin(angle) * up);
    mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
    return Surface(mesh, Walls());
}

constexpr TriangleFeature kCommonEdge = TriangleFeature::edge1; // of the first triangle

TEST(Surface, TakesTrianglesForOnePlaneUpToABendThatSphereCastsIgnore)
{
    for (const double angle : {0.0, 1e-9, -5e-8, 1.3e-7})
    {
        const Surface surface = hinge(angle);
        EXPECT_TRUE(surface[0].isFlat(kCommonEdge)) << angle;
        EXPECT_TRUE(surface[0].isFlat(TriangleFeature::corner1)) << angle;
    }
    for (const double angle : {1.6e-7, -2e-7, 1e-6, 0.1, 3.0})
    {
        const Surface surface = hinge(angle);
        EXPECT_FALSE(surface[0].isFlat(kCommonEdge)) << angle;
        EXPECT_FALSE(surface[0].isFlat(TriangleFeature::corner1)) << angle;
        EXPECT_TRUE(surface[0].isFlat(TriangleFeature::corner0)) << "a corner of one triangle";
    }
}

TEST(Surface, TellsTheSideByTheNearestFeature)
{
    const Surface surface = hinge(-0.5); // bent away from where the normals point
    EXPECT_LT(signedDistance(surface, 0, {0.2, 0.2, 0.3}).value, 0);
    EXPECT_GT(signedDistance(surface, 0, {0.2, 0.2, -0.3}).value, 0);
    const std::array<std::uint32_t, 2> both = {0, 1};
    EXPECT_LT(nearestDistance(surface, both, {0.6, 0.6, 0.1}).value, 0);
    EXPECT_GT(nearestDistance(surface, both, {0.6, 0.6, -0.3}).value, 0);
}

} // namespace
} // namespace frostfill

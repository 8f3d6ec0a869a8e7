// SPDX-License-Identifier: MIT
#include "mesh/interior/surface.hpp"

#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

/// Two tetrahedra on one edge, from (0, 0, 0) to (0, 0, 1).
TriangleMesh tetrahedraOnOneEdge()
{
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -2, 0}};
    for (const std::uint32_t first : {2U, 4U})
    {
        const std::uint32_t second = first + 1;
        mesh.triangles.insert(
            mesh.triangles.end(),
            {{0, first, 1}, {0, 1, second}, {0, second, first}, {1, first, second}});
    }
    return mesh;
}

TEST(Surface, GivesAnEdgeTheSumOfTheNormalsOfAllItsTriangles)
{
    const TriangleMesh mesh = tetrahedraOnOneEdge();
    const Surface surface(mesh, Walls());
    for (std::uint32_t triangle = 0; triangle < surface.size(); ++triangle)
    {
        for (std::size_t side = 0; side < 3; ++side)
        {
            const auto& t = mesh.triangles[triangle];
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (std::uint32_t other = 0; other < surface.size(); ++other)
            {
                const auto& o = mesh.triangles[other];
                const bool isAt = std::count(o.begin(), o.end(), t[side]) > 0 &&
                                  std::count(o.begin(), o.end(), t[(side + 1) % 3]) > 0;
                sum += isAt ? surface.bound(other).normal : Eigen::Vector3d::Zero();
            }
            const auto feature = static_cast<TriangleFeature>(3 + side);
            EXPECT_EQ(surface.pseudonormal(triangle, feature), sum) << triangle << ' ' << side;
        }
    }
}

TEST(Surface, IsTheSameWhateverTheThreadsThatMakeIt)
{
    const TriangleMesh mesh = shapes::torus(2, 0.5, 211, 61);
    ASSERT_GT(mesh.triangles.size(), MeshIndex::kWorthThreads);
    const Walls walls = classifyWalls(mesh);
    EXPECT_EQ(classifyWalls(mesh, MeshIndex(mesh, 3)).twoSided, walls.twoSided);
    const Surface expected(mesh, walls, MeshIndex(mesh, 1));
    const Surface surface(mesh, walls, MeshIndex(mesh, 3));
    EXPECT_TRUE(std::equal(surface.tree().order().begin(), surface.tree().order().end(),
                           expected.tree().order().begin()));
    EXPECT_EQ(surface.box().min(), expected.box().min());
    for (std::uint32_t t = 0; t < surface.size(); ++t)
    {
        ASSERT_EQ(surface.bound(t).normal, expected.bound(t).normal);
        ASSERT_EQ(surface[t].flatFeatures, expected[t].flatFeatures);
        const Eigen::Vector3d p = surface.bound(t).centre + 0.1 * surface.bound(t).normal;
        ASSERT_EQ(nearestDistance(surface, p, 1).value, nearestDistance(expected, p, 1).value);
    }
}

TEST(Surface, WithATreeThatMovedWithItsMeshFindsTheSame)
{
    const TriangleMesh mesh = shapes::torus(1, 0.4, 60, 20);
    const Eigen::Vector3d origin(300, -100, 700);
    const double length = 0.2;
    TriangleMesh moved = mesh;
    for (Eigen::Vector3d& vertex : moved.vertices)
    {
        const Eigen::Vector3d q = (vertex - origin) / length;
        vertex = {q.z(), q.x(), q.y()};
    }
    MeshIndex index(mesh);
    const Walls walls = classifyWalls(mesh, index);
    index.tree.move(origin, length, {2, 0, 1});
    const Surface surface(moved, walls, std::move(index));
    const Surface expected(moved);
    for (std::uint32_t t = 0; t < surface.size(); ++t)
    {
        for (const double side : {-3.0, -0.1, 0.1, 0.7})
        {
            const Eigen::Vector3d p = surface.bound(t).centre + side * surface.bound(t).normal;
            ASSERT_EQ(nearestDistance(surface, p, 9).value, nearestDistance(expected, p, 9).value);
        }
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

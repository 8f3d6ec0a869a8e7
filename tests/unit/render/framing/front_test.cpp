// SPDX-License-Identifier: MIT
#include "render/framing/framing.hpp"
#include "support/pictures.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using namespace testing_support;

/// A trunk with a head that is as far off in `direction`.
TriangleMesh animal(const Eigen::Vector3d& direction)
{
    TriangleMesh mesh = boxMesh({0.5, 0.5, 0.5});
    const TriangleMesh head = boxMesh({0.4, 0.4, 0.4}, Eigen::Vector3d(0, 1, 0) + direction);
    for (const auto& [a, b, c] : head.triangles)
    {
        mesh.triangles.push_back({a + 8, b + 8, c + 8});
    }
    mesh.vertices.insert(mesh.vertices.end(), head.vertices.begin(), head.vertices.end());
    return mesh;
}

TEST(Front, IsWhereTheUpperHalfLeansTo)
{
    EXPECT_EQ(frontAzimuth(animal({0, 0, 1}), {0, 1, 0}), 30);
    EXPECT_EQ(frontAzimuth(animal({1, 0, 0}), {0, 1, 0}), 30) << "seen from the side";
    EXPECT_EQ(frontAzimuth(animal({0, 0, -1}), {0, 1, 0}), 210);
}

TEST(Front, IsTheUsualSideOfWhatLeansToNoSide)
{
    EXPECT_EQ(frontAzimuth(boxMesh({1, 2, 3}), {0, 1, 0}), 30);
    EXPECT_EQ(frontAzimuth(torusMesh(1, 0.4, 24, 8), {0, 0, 1}), 30);
    EXPECT_EQ(frontAzimuth(animal({0, 0, -0.1}), {0, 1, 0}), 30);
    EXPECT_EQ(frontAzimuth({}, {0, 1, 0}), 30);
}

TEST(Front, FollowsTheUpAxis)
{
    // With z up the camera of azimuth 0 stands at -y.
    TriangleMesh mesh = animal({0, 0, -1});
    for (Eigen::Vector3d& vertex : mesh.vertices)
    {
        vertex = Eigen::Vector3d(vertex.x(), -vertex.z(), vertex.y());
    }
    EXPECT_EQ(frontAzimuth(mesh, {0, 0, 1}), 210);
}

} // namespace
} // namespace frostfill

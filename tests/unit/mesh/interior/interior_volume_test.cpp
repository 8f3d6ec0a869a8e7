// SPDX-License-Identifier: MIT
#include "mesh/interior/winding_columns.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

TriangleMesh both(TriangleMesh mesh, const TriangleMesh& other)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles)
    {
        mesh.triangles.push_back({a + first, b + first, c + first});
    }
    return mesh;
}

TEST(InteriorVolume, IsTheSignedVolumeWhereNothingCrosses)
{
    for (const TriangleMesh& mesh :
         {shapes::box({0, 0, 0}, {1, 2, 3}), shapes::torus(), shapes::torus(3, 0.1)})
    {
        EXPECT_NEAR(interiorVolume(mesh) / signedVolume(mesh), 1, 1e-4);
    }
}

TEST(InteriorVolume, CountsOverlapsOnce)
{
    const TriangleMesh boxes =
        both(shapes::box({0, 0, 0}, {2, 2, 2}), shapes::box({1, 1, 1}, {3, 3, 3}));
    EXPECT_NEAR(interiorVolume(boxes) / 15, 1, 1e-4);
    const TriangleMesh shells =
        both(shapes::box({0, 0, 0}, {3, 3, 3}), shapes::box({1, 1, 1}, {2, 2, 2}));
    EXPECT_NEAR(interiorVolume(shells) / 27, 1, 1e-4);
}

TEST(InteriorVolume, LeavesCavitiesOut)
{
    TriangleMesh cavity = shapes::box({1, 1, 1}, {2, 2, 2});
    for (auto& triangle : cavity.triangles)
    {
        std::swap(triangle[1], triangle[2]);
    }
    EXPECT_NEAR(interiorVolume(both(shapes::box({0, 0, 0}, {3, 3, 3}), cavity)) / 26, 1, 1e-4);
    EXPECT_EQ(interiorVolume(cavity), 0) << "inside out";
}

TEST(InteriorVolume, IsTheSameNumberOnAnyNumberOfThreads)
{
    const TriangleMesh mesh =
        both(shapes::torus(3, 1, 60, 30), shapes::box({-4, -2, -1}, {2, 2, 3}, 9));
    for (const int count : {2, 3, 8})
    {
        Threads threads(count);
        EXPECT_EQ(interiorVolume(mesh, threads), interiorVolume(mesh));
    }
}

TEST(InteriorVolume, OfAFlatOrEmptyMeshIsZero)
{
    EXPECT_EQ(interiorVolume({}), 0);
    TriangleMesh flat;
    flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    flat.triangles = {{0, 1, 2}, {0, 2, 1}};
    EXPECT_EQ(interiorVolume(flat), 0);
}

} // namespace
} // namespace frostfill

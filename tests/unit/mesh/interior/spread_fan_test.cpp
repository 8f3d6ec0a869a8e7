// SPDX-License-Identifier: MIT
#include "mesh/interior/walls.hpp"
#include "unit/mesh/interior/surface_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace frostfill
{
namespace
{

/// Vertex 0 at the origin, and triangles from each point of a closed path to the next.
TriangleMesh fanOf(const std::vector<Eigen::Vector3d>& path)
{
    TriangleMesh mesh;
    mesh.vertices.emplace_back(0, 0, 0);
    const auto count = static_cast<std::uint32_t>(path.size());
    for (std::uint32_t i = 0; i < count; ++i)
    {
        mesh.vertices.push_back(path[i]);
        mesh.triangles.push_back({0, i + 1, (i + 1) % count + 1});
    }
    return mesh;
}

/// Goes round the vertical axis `turns` times.
TriangleMesh roundFan(int count, int turns = 1)
{
    std::vector<Eigen::Vector3d> path;
    for (int i = 0; i < count; ++i)
    {
        const double angle = 2 * std::numbers::pi * turns * i / count;
        path.emplace_back(std::cos(angle), std::sin(angle), -0.3 - 0.01 * i);
    }
    return fanOf(path);
}

bool isSpread(const TriangleMesh& mesh)
{
    std::vector<std::uint32_t> triangles(mesh.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0U);
    return fanAt(mesh, 0, triangles) == Fan::spread;
}

TEST(SpreadFan, IsAConeOfAnyDepth)
{
    for (const double height : {0.0, 0.1, 3.0, -3.0})
    {
        TriangleMesh cone = roundFan(7);
        cone.vertices[0].z() = height;
        EXPECT_TRUE(isSpread(cone)) << height;
    }
}

TEST(SpreadFan, MayNotGoRoundTwice)
{
    EXPECT_FALSE(isSpread(roundFan(9, 2)));
}

TEST(SpreadFan, MayNotGoBack)
{
    TriangleMesh mesh = roundFan(8);
    std::swap(mesh.vertices[2], mesh.vertices[3]);
    EXPECT_FALSE(isSpread(mesh));
}

TEST(SpreadFan, MustBeClosed)
{
    TriangleMesh mesh = roundFan(8);
    mesh.triangles.pop_back();
    EXPECT_FALSE(isSpread(mesh));
}

TEST(SpreadFan, MayNotBeTwoFans)
{
    TriangleMesh mesh = roundFan(5);
    const TriangleMesh second = roundFan(6);
    for (auto triangle : second.triangles)
    {
        mesh.triangles.push_back({0, triangle[1] + 5, triangle[2] + 5});
    }
    for (std::size_t i = 1; i < second.vertices.size(); ++i)
    {
        mesh.vertices.emplace_back(second.vertices[i] - Eigen::Vector3d(0, 0, 1));
    }
    EXPECT_FALSE(isSpread(mesh));
}

TEST(SpreadFan, MayNotHaveATriangleWithoutArea)
{
    TriangleMesh mesh = roundFan(8);
    mesh.vertices[4] = 2 * mesh.vertices[3];
    EXPECT_FALSE(isSpread(mesh));
}

// The fans range from flat to crumpled. A spread one may have no pair that crosses.
TEST(SpreadFan, HasNoTrianglesThatCross)
{
    int spread = 0;
    int crossed = 0;
    for (unsigned seed = 0; seed < 4000; ++seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(-1, 1);
        const int count = 3 + static_cast<int>(seed % 10);
        const double crumple = 0.02 * (seed % 60);
        TriangleMesh mesh = roundFan(count, seed % 7 == 0 && count > 4 ? 2 : 1);
        for (std::size_t i = 1; i < mesh.vertices.size(); ++i)
        {
            mesh.vertices[i] += crumple * Eigen::Vector3d(unit(random), unit(random), unit(random));
        }
        if (isSpread(mesh))
        {
            ++spread;
            // Without one of its triangles a fan is searched pair by pair.
            for (std::size_t i = 0; i + 1 < mesh.triangles.size(); ++i)
            {
                TriangleMesh open = mesh;
                open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(i));
                ASSERT_TRUE(test::crossingsOf(open).none()) << "seed " << seed;
            }
        }
        else
        {
            TriangleMesh open = mesh;
            open.triangles.pop_back();
            crossed += test::crossingsOf(open).none() ? 0 : 1;
        }
    }
    EXPECT_GT(spread, 1000);
    EXPECT_GT(crossed, 500);
}

} // namespace
} // namespace frostfill

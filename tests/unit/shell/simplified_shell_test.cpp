// SPDX-License-Identifier: MIT
#include "shell/simplified_shell.hpp"

#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace frostfill
{
namespace
{

constexpr double kTube = 0.4;

/// 60,000 triangles.
const TriangleMesh& denseTorus()
{
    static const TriangleMesh mesh = shapes::torus(1, kTube, 300, 100);
    return mesh;
}

/// Of a point from the true torus, the closed form.
double distanceToTorus(const Eigen::Vector3d& p)
{
    return std::abs(std::hypot(std::hypot(p.x(), p.y()) - 1, p.z()) - kTube);
}

TEST(SimplifiedShell, OfAMeshOfFewTrianglesIsTheMesh)
{
    const TriangleMesh mesh = shapes::torus();
    const SimplifiedShell shell = simplifyShell(mesh);
    EXPECT_TRUE(shell.isTrue());
    EXPECT_EQ(shell.mesh.triangles, mesh.triangles);
    EXPECT_EQ(shell.mesh.vertices, mesh.vertices);
    EXPECT_EQ(shell.facts.distance, 0);
    EXPECT_EQ(shell.facts.triangles, mesh.triangles.size());
}

TEST(SimplifiedShell, OfADenseMeshIsTheMeshWhereItIsAskedFor)
{
    const SimplifiedShell shell = simplifyShell(denseTorus(), true);
    EXPECT_TRUE(shell.isTrue());
    EXPECT_EQ(shell.mesh.triangles, denseTorus().triangles);
}

TEST(SimplifiedShell, OfADenseMeshHasFewTrianglesNearIt)
{
    const SimplifiedShell shell = simplifyShell(denseTorus());
    EXPECT_LE(shell.mesh.triangles.size(), kShellTriangles);
    EXPECT_GT(shell.mesh.triangles.size(), kShellTriangles / 2);
    EXPECT_EQ(shell.facts.triangles, shell.mesh.triangles.size());
    EXPECT_EQ(shell.facts.meshTriangles, denseTorus().triangles.size());
    EXPECT_GT(shell.facts.distance, 0);
    EXPECT_LT(shell.facts.distance, kShellDistance * 2.8);
    // The dense mesh itself is within a chord of its polygons from the true torus.
    const double chord = 1.4 * (1 - std::cos(std::numbers::pi / 300)) +
                         kTube * (1 - std::cos(std::numbers::pi / 100));
    for (const auto& [a, b, c] : shell.mesh.triangles)
    {
        const auto& v = shell.mesh.vertices;
        EXPECT_LE(distanceToTorus((v[a] + v[b] + v[c]) / 3), shell.facts.distance + chord);
        EXPECT_LE(distanceToTorus((v[a] + v[b]) / 2), shell.facts.distance + chord);
    }
}

TEST(SimplifiedShell, IsClosedAndUsesAllItsVertices)
{
    const SimplifiedShell shell = simplifyShell(denseTorus());
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::set<std::uint32_t> used;
    for (const auto& triangle : shell.mesh.triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            edges.insert({triangle[k], triangle[(k + 1) % 3]});
            used.insert(triangle[k]);
        }
    }
    for (const auto& [a, b] : edges)
    {
        EXPECT_EQ(edges.count({a, b}), 1U);
        EXPECT_EQ(edges.count({b, a}), 1U);
    }
    EXPECT_EQ(used.size(), shell.mesh.vertices.size());
}

TEST(SimplifiedShell, StandsForEveryTriangleAndForSomeEach)
{
    const SimplifiedShell shell = simplifyShell(denseTorus());
    std::set<std::uint32_t> stands;
    std::set<std::uint32_t> triangles;
    for (const auto& [stand, triangle] : shell.standsFor)
    {
        stands.insert(stand);
        triangles.insert(triangle);
    }
    EXPECT_EQ(stands.size(), shell.mesh.triangles.size());
    EXPECT_EQ(triangles.size(), denseTorus().triangles.size());
}

TEST(SimplifiedShell, ShowsATriangleDiscardedWhenAllThatItStandsForAre)
{
    SimplifiedShell shell;
    shell.mesh.triangles.resize(3);
    shell.standsFor = {{0, 0}, {0, 1}, {1, 2}, {2, 3}, {2, 0}};
    const auto active = PolygonState::active;
    const auto gone = PolygonState::discarded;
    std::vector<PolygonState> shown;
    showPolygons(shell, std::vector{gone, active, gone, gone}, shown);
    EXPECT_EQ(shown, (std::vector{active, gone, gone}));
    showPolygons(shell, std::vector{gone, gone, active, gone}, shown);
    EXPECT_EQ(shown, (std::vector{gone, active, gone}));
    showPolygons({}, std::vector{active, gone}, shown);
    EXPECT_EQ(shown, (std::vector{active, gone}));
}

} // namespace
} // namespace frostfill

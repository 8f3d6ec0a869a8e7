// SPDX-License-Identifier: MIT
// Triangles without area: chains of them, needles, and both at once.
#include "mesh/connectivity.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <random>

namespace frostfill
{
namespace
{

std::size_t edgesThatDoNotCancel(const TriangleMesh& mesh)
{
    std::size_t count = 0;
    EdgeTable(mesh).forEach([&](std::span<const EdgeUse> uses) { count += cancels(uses) ? 0 : 1; });
    return count;
}

/// A new vertex on a side of a triangle. The triangle is cut there. The neighbour is cut too, or a
/// triangle without area lies between.
void addVertex(TriangleMesh& mesh, std::size_t triangle, std::size_t side, double along,
               bool cutsNeighbour)
{
    const auto t = mesh.triangles[triangle];
    const std::uint32_t a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
    const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto other = std::find_if(mesh.triangles.begin(), mesh.triangles.end(),
                                    [&](const auto& n) {
                                        return (n[0] == b && n[1] == a) ||
                                               (n[1] == b && n[2] == a) || (n[2] == b && n[0] == a);
                                    });
    ASSERT_NE(other, mesh.triangles.end());
    const auto neighbour = *other;
    mesh.vertices.push_back(mesh.vertices[a] + along * (mesh.vertices[b] - mesh.vertices[a]));
    mesh.triangles[triangle] = {a, v, c};
    if (cutsNeighbour)
    {
        const std::uint32_t d =
            *std::find_if(neighbour.begin(), neighbour.end(),
                          [&](std::uint32_t corner) { return corner != a && corner != b; });
        *other = {b, v, d};
        mesh.triangles.push_back({v, a, d});
    }
    else
    {
        mesh.triangles.push_back({a, b, v});
    }
    mesh.triangles.push_back({v, b, c});
}

TEST(DropFlatTriangles, LeavesMeshesOfNeedlesClosedWithTheirVolume)
{
    std::mt19937 random(1);
    for (int trial = 0; trial < 300; ++trial)
    {
        TriangleMesh mesh = shapes::box({0, 0, 0}, {1, 2, 3}, 2);
        for (int i = 0; i < 12; ++i)
        {
            const bool isNeedle = random() % 2 == 0;
            addVertex(mesh, random() % mesh.triangles.size(), random() % 3,
                      isNeedle ? 1e-14 : 0.25 + 0.005 * static_cast<double>(random() % 100),
                      random() % 2 == 0);
        }
        std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
        ASSERT_EQ(edgesThatDoNotCancel(mesh), 0U);
        ASSERT_NEAR(signedVolume(mesh), 6, 1e-9);
        const TriangleMesh before = mesh;
        dropFlatTriangles(mesh);
        ASSERT_EQ(edgesThatDoNotCancel(mesh), 0U) << "trial " << trial;
        ASSERT_NEAR(signedVolume(mesh), 6, 1e-9) << "trial " << trial;
        ASSERT_EQ(inspectMesh(mesh).degenerateTriangles, 0U) << "trial " << trial;
    }
}

TEST(DropFlatTriangles, TakesAChainOfAnyLength)
{
    // One edge of a box has vertices that one face uses; the other face fills the gap with a fan.
    constexpr std::uint32_t kChain = 100;
    TriangleMesh mesh = test::box(0, 1);
    auto& cut = mesh.triangles[0]; // {0, 2, 3}
    ASSERT_EQ(cut, (std::array<std::uint32_t, 3>{0, 2, 3}));
    std::uint32_t last = 0;
    for (std::uint32_t i = 1; i <= kChain; ++i)
    {
        const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.emplace_back(0, i / (kChain + 1.0), 0);
        mesh.triangles.push_back({last, v, 3});
        if (last != 0)
        {
            mesh.triangles.push_back({0, v, last});
        }
        last = v;
    }
    mesh.triangles[0] = {last, 2, 3};
    mesh.triangles.push_back({0, 2, last});
    ASSERT_EQ(inspectMesh(mesh).degenerateTriangles, kChain);
    const LoadedMesh loaded = repairMesh(mesh, "box");
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_NEAR(loaded.report.volume, 1, 1e-12);
    EXPECT_EQ(loaded.report.degenerateTriangles, 0U);
}

TEST(DropFlatTriangles, TakesThoseAtEdgesOfFour)
{
    // Two boxes share an edge; beside it one has a triangle without area.
    TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
    test::append(mesh, test::box({1, 1, 0}, {2, 2, 1}));
    for (auto& t : mesh.triangles)
    {
        for (const auto& [own, shared] : {std::pair{8U, 3U}, {12U, 7U}})
        {
            std::replace(t.begin(), t.end(), own, shared);
        }
    }
    // {1, 3, 7} is cut at a vertex in the middle of the edge 3-7.
    const auto cut = std::find(mesh.triangles.begin(), mesh.triangles.end(),
                               std::array<std::uint32_t, 3>{1, 3, 7});
    ASSERT_NE(cut, mesh.triangles.end());
    const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(1, 1, 0.5);
    *cut = {1, 3, v};
    mesh.triangles.push_back({1, v, 7});
    mesh.triangles.push_back({3, 7, v});
    ASSERT_EQ(edgesThatDoNotCancel(mesh), 0U);
    const LoadedMesh loaded = repairMesh(mesh, "boxes");
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.degenerateTriangles, 0U);
    EXPECT_NEAR(loaded.report.volume, 2, 1e-12);
}

} // namespace
} // namespace frostfill

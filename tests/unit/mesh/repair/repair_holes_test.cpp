// SPDX-License-Identifier: MIT
#include "support/winding_number.hpp"
#include "unit/mesh/mesh_samples.hpp"

namespace frostfill
{
namespace
{

TEST(RepairHoles, ClosesASingleMissingTriangleExactly)
{
    TriangleMesh mesh = builtInMesh("cube");
    mesh.triangles.erase(mesh.triangles.begin() + 100);
    const LoadedMesh loaded = repairMesh(mesh, "cube");
    test::expectOnlyRepair(loaded, "closed a hole of 3 edges near (");
    EXPECT_EQ(loaded.report.triangles, 768U);
    EXPECT_EQ(loaded.report.volume, 8.0);
}

TEST(RepairHoles, ClosesAFlatHoleWithoutChangingTheVolume)
{
    // All triangles around a vertex in the middle of a face: a hole of six edges, or of eight.
    TriangleMesh mesh = builtInMesh("cube");
    const auto inner =
        std::find(mesh.vertices.begin(), mesh.vertices.end(), Eigen::Vector3d(0.25, 0.25, 1));
    ASSERT_NE(inner, mesh.vertices.end());
    const auto vertex = static_cast<std::uint32_t>(inner - mesh.vertices.begin());
    std::erase_if(mesh.triangles,
                  [&](const auto& t) { return std::find(t.begin(), t.end(), vertex) != t.end(); });
    const LoadedMesh loaded = repairMesh(mesh, "cube");
    ASSERT_EQ(loaded.repairs.size(), 2U); // the hole, and the vertex that is left over
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.degenerateTriangles, 0U);
    EXPECT_DOUBLE_EQ(loaded.report.volume, 8.0);
    EXPECT_DOUBLE_EQ(loaded.report.area, 24.0);
}

TEST(RepairHoles, ClosesTheTopOfTheSphereNearlyAsItWas)
{
    TriangleMesh mesh = builtInMesh("sphere");
    const double volume = signedVolume(mesh);
    mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 32);
    const LoadedMesh loaded = repairMesh(mesh, "sphere");
    ASSERT_FALSE(loaded.repairs.empty());
    EXPECT_NE(loaded.repairs[0].find("32 edges"), std::string::npos) << loaded.repairs[0];
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.genus, 0);
    EXPECT_NEAR(loaded.report.volume, volume, 1e-3 * volume);
}

TEST(RepairHoles, ClosesHolesThatMeetInAVertex)
{
    TriangleMesh mesh = builtInMesh("cube");
    const auto inner =
        std::find(mesh.vertices.begin(), mesh.vertices.end(), Eigen::Vector3d(0.25, 0.25, 1));
    const auto vertex = static_cast<std::uint32_t>(inner - mesh.vertices.begin());
    std::vector<std::size_t> around;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
        if (std::count(mesh.triangles[i].begin(), mesh.triangles[i].end(), vertex) > 0)
        {
            around.push_back(i);
        }
    }
    // Of the triangles around the vertex two that share no edge.
    for (const std::size_t other : around)
    {
        std::size_t shared = 0;
        for (const std::uint32_t corner : mesh.triangles[other])
        {
            shared += static_cast<std::size_t>(std::count(mesh.triangles[around[0]].begin(),
                                                          mesh.triangles[around[0]].end(), corner));
        }
        if (shared != 1)
        {
            continue;
        }
        mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(other));
        mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(around[0]));
        break;
    }
    ASSERT_EQ(mesh.triangles.size(), 766U);
    const LoadedMesh loaded = repairMesh(mesh, "cube");
    EXPECT_EQ(loaded.repairs.size(), 2U);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.volume, 8.0);
}

TEST(RepairHoles, RefusesToGuessALargeLid)
{
    TriangleMesh mesh = builtInMesh("cube");
    std::erase_if(mesh.triangles,
                  [&](const auto& t)
                  {
                      return std::all_of(t.begin(), t.end(),
                                         [&](auto corner)
                                         { return mesh.vertices[corner].y() == 1; });
                  });
    test::expectRefused(ErrorCode::badData, "a hole of 32 edges near (0 1 0) is too large",
                        [&] { (void)repairMesh(mesh, "tub"); });
}

TEST(RepairHoles, MakesAConsistentSurfaceOfManyDefectsAtOnce)
{
    TriangleMesh mesh = builtInMesh("human");
    const double volume = signedVolume(mesh);
    for (std::size_t i = 50; i < mesh.triangles.size(); i += 97)
    {
        test::flip(mesh.triangles[i]);
    }
    mesh.triangles.push_back(mesh.triangles[10]);
    mesh.triangles.push_back({4, 4, 9});
    for (std::size_t i = 2100; i > 100; i -= 131)
    {
        mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(i));
    }
    test::flipAll(mesh);
    const LoadedMesh loaded = repairMesh(mesh, "human");
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.triangles, 2218U);
    EXPECT_DOUBLE_EQ(loaded.report.volume, volume);
    EXPECT_GE(loaded.repairs.size(), 5U);
    EXPECT_NEAR(windingNumber(loaded.mesh, {0, 1.2, 0}), 1, 1e-9);
}

/// A square in the plane of `height`, of the size of a unit cube's side.
TriangleMesh square(double height)
{
    return {{{0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height}},
            {{0, 1, 2}, {0, 2, 3}}};
}

TEST(RepairHoles, MakesNoEnvelopesOfSheets)
{
    TriangleMesh mesh;
    for (int i = 0; i < 30; ++i)
    {
        test::append(mesh, square(2 * i)); // a lid would be a thirtieth of the surface
    }
    test::expectRefused(ErrorCode::badData, "is the rim of a sheet",
                        [&] { (void)repairMesh(mesh, "squares"); });
}

TEST(RepairHoles, RemovesSheetsBesideASolid)
{
    TriangleMesh mesh = builtInMesh("cube");
    test::append(mesh, square(3));
    test::append(mesh, square(0)); // inside
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{5, 0, 0}, {6, 0.1, 0}, {5.5, 1, 0.3}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    const LoadedMesh loaded = repairMesh(mesh, "cube");
    ASSERT_EQ(loaded.repairs.size(), 2U);
    EXPECT_EQ(loaded.repairs[0], "removed 5 triangles of open sheets that enclose nothing");
    EXPECT_EQ(loaded.repairs[1], "removed 11 unused vertices");
    EXPECT_EQ(loaded.report.volume, 8.0);
}

TEST(RepairHoles, KeepsThinPiecesThatEncloseSomething)
{
    TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1e-4}); // a plate with a hole in its rim
    mesh.triangles.erase(mesh.triangles.begin() + 4);
    const LoadedMesh loaded = repairMesh(mesh, "plate");
    test::expectOnlyRepair(loaded, "closed a hole of 3 edges");
    EXPECT_NEAR(loaded.report.volume, 1e-4, 1e-18);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "mesh/repair/repair_steps.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <ctime>

namespace frostfill
{
namespace
{

/// Splits the first side of a triangle at `share`; the neighbour there does not learn of it.
void addTJunction(TriangleMesh& mesh, std::size_t triangle, double share)
{
    const auto t = mesh.triangles[triangle];
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back((1 - share) * mesh.vertices[t[0]] + share * mesh.vertices[t[1]]);
    mesh.triangles[triangle] = {t[0], middle, t[2]};
    mesh.triangles.push_back({middle, t[1], t[2]});
}

/// The upper half of the sphere has vertices of its own, `gap` above the lower half's.
TriangleMesh crackedSphere(double gap)
{
    TriangleMesh mesh = builtInMesh("sphere");
    const std::size_t count = mesh.vertices.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        mesh.vertices.emplace_back(mesh.vertices[i] + Eigen::Vector3d(0, gap, 0));
    }
    for (auto& t : mesh.triangles)
    {
        const double middle =
            mesh.vertices[t[0]].y() + mesh.vertices[t[1]].y() + mesh.vertices[t[2]].y();
        for (std::uint32_t& corner : t)
        {
            corner += middle > 0 ? static_cast<std::uint32_t>(count) : 0;
        }
    }
    return mesh;
}

bool says(const LoadedMesh& loaded, const std::string& part)
{
    return std::any_of(loaded.repairs.begin(), loaded.repairs.end(),
                       [&](const std::string& repair)
                       { return repair.find(part) != std::string::npos; });
}

TEST(StitchSeams, SplitsAnEdgeAtAVertexThatItsNeighbourHas)
{
    TriangleMesh mesh = test::box(0, 1);
    addTJunction(mesh, 0, 0.25);
    ASSERT_EQ(inspectMesh(mesh).boundaryEdges, 3U);
    const LoadedMesh loaded = repairMesh(mesh, "box");
    test::expectOnlyRepair(loaded, "split open edges at 1 vertex");
    EXPECT_EQ(loaded.report.volume, 1.0);
    EXPECT_EQ(loaded.report.triangles, 14U);
}

TEST(StitchSeams, SplitsManyEdgesAndAllSidesOfATriangle)
{
    TriangleMesh mesh = builtInMesh("torus");
    const double volume = signedVolume(mesh);
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; i += 2)
    {
        std::rotate(mesh.triangles[i].begin(), mesh.triangles[i].begin() + i % 3,
                    mesh.triangles[i].end());
        addTJunction(mesh, i, 0.1 + 0.8 * static_cast<double>(i) / static_cast<double>(count));
    }
    const LoadedMesh loaded = repairMesh(mesh, "torus");
    EXPECT_TRUE(says(loaded, "split open edges at"));
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.genus, 1);
    EXPECT_NEAR(loaded.report.volume, volume, 1e-12 * volume);

    TriangleMesh box = test::box(0, 1);
    for (int i = 0; i < 3; ++i)
    {
        for (std::size_t triangle = 4; triangle < 12; ++triangle)
        {
            std::rotate(box.triangles[triangle].begin(), box.triangles[triangle].begin() + 1,
                        box.triangles[triangle].end());
            addTJunction(box, triangle, 0.3);
        }
    }
    const LoadedMesh whole = repairMesh(box, "box");
    EXPECT_TRUE(whole.report.closed());
    EXPECT_NEAR(whole.report.volume, 1, 1e-12);
}

TEST(StitchSeams, LeavesVerticesThatLieBesideAnEdge)
{
    TriangleMesh mesh = test::box(0, 1);
    addTJunction(mesh, 0, 0.5);
    mesh.vertices.back() += Eigen::Vector3d(0, 0, -0.01);
    const TriangleMesh before = mesh;
    EXPECT_EQ(splitAtTJunctions(mesh, 1e-6), 0U);
    EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(StitchSeams, GivesUpOnEdgesThatLieOnEachOtherWithoutEnd)
{
    // Each of the fans has an edge on the same line, and all the others' ends lie on it.
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < 20'000; ++i)
    {
        mesh.vertices.emplace_back(-1.0 - i, 0, 0);
        mesh.vertices.emplace_back(1.0 + i, 0, 0);
        mesh.vertices.emplace_back(0, 1, i);
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const std::clock_t begin = std::clock();
    EXPECT_EQ(splitAtTJunctions(mesh, 1e-6), 0U);
    EXPECT_EQ(mesh.triangles.size(), 20'000U);
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5);
}

TEST(StitchSeams, JoinsCracksOfUpToAThousandthOfTheSize)
{
    const double volume = signedVolume(builtInMesh("sphere"));
    for (const double gap : {1e-7, 1e-6, 1e-5, 1e-4, 3e-4, 2e-3})
    {
        SCOPED_TRACE(gap);
        const LoadedMesh loaded = repairMesh(crackedSphere(gap), "sphere");
        EXPECT_TRUE(says(loaded, "joined 32 vertices along open seams"));
        EXPECT_TRUE(loaded.report.closed());
        EXPECT_EQ(loaded.report.components, 1U);
        EXPECT_EQ(loaded.report.triangles, 960U);
        EXPECT_NEAR(loaded.report.volume, volume, 3.2 * gap); // the seam encloses pi gap
    }
    EXPECT_THROW((void)repairMesh(crackedSphere(1e-2), "sphere"), Error);
}

TEST(StitchSeams, NamesTheSmallestDistanceThatClosesTheSurface)
{
    EXPECT_TRUE(says(repairMesh(crackedSphere(1e-6), "sphere"), "closer than 1e-06 of"));
    EXPECT_TRUE(says(repairMesh(crackedSphere(2e-5), "sphere"), "closer than 1e-05 of"));
    EXPECT_TRUE(says(repairMesh(crackedSphere(2e-4), "sphere"), "closer than 0.0001 of"));
}

TEST(StitchSeams, UsesALargeDistanceOnlyIfItClosesTheSurface)
{
    TriangleMesh mesh = crackedSphere(1e-4);
    mesh.triangles.erase(mesh.triangles.begin() + 5);
    const TriangleMesh before = mesh;
    EXPECT_TRUE(stitchSeams(mesh).empty());
    EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(StitchSeams, LetsNoSmallTriangleVanishInASeam)
{
    // A hole in the middle of a side that is smaller than the widest seam.
    TriangleMesh mesh = test::box(0, 1);
    const auto t = mesh.triangles[0];
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const Eigen::Vector3d middle =
        (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3;
    for (const std::uint32_t corner : t)
    {
        mesh.vertices.emplace_back(middle + 5e-5 * (mesh.vertices[corner] - middle));
    }
    mesh.triangles.erase(mesh.triangles.begin());
    for (std::uint32_t i = 0; i < 3; ++i)
    {
        const std::uint32_t j = (i + 1) % 3;
        mesh.triangles.push_back({t[i], t[j], first + i});
        mesh.triangles.push_back({t[j], first + j, first + i});
    }
    const LoadedMesh loaded = repairMesh(mesh, "box");
    test::expectOnlyRepair(loaded, "closed a hole of 3 edges");
    EXPECT_NEAR(loaded.report.volume, 1, 1e-15);
}

} // namespace
} // namespace frostfill

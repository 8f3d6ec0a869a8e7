// SPDX-License-Identifier: MIT
#include "unit/mesh/mesh_samples.hpp"

namespace frostfill
{
namespace
{

TEST(InspectMesh, FindsNothingWrongWithABox)
{
    const MeshReport report = inspectMesh(test::box(0, 1));
    EXPECT_TRUE(report.closed());
    EXPECT_EQ(report.vertices, 8U);
    EXPECT_EQ(report.triangles, 12U);
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.genus, 0);
    EXPECT_EQ(report.degenerateTriangles + report.duplicateTriangles + report.unusedVertices, 0U);
    EXPECT_EQ(report.volume, 1.0);
    EXPECT_EQ(report.area, 6.0);
}

TEST(InspectMesh, CountsTheRimOfAHoleAndSaysWhere)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
    const MeshReport report = inspectMesh(mesh);
    EXPECT_EQ(report.boundaryEdges, 4U);
    EXPECT_FALSE(report.closed());
    EXPECT_EQ(report.firstDefect.z(), 1.0);
}

TEST(InspectMesh, CountsInconsistentEdges)
{
    TriangleMesh mesh = test::box(0, 1);
    test::flip(mesh.triangles[5]);
    EXPECT_EQ(inspectMesh(mesh).inconsistentEdges, 3U);
}

TEST(InspectMesh, CountsNonManifoldEdges)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.vertices.emplace_back(-1, -1, 0.5);
    mesh.triangles.push_back({0, 4, 8});
    const MeshReport report = inspectMesh(mesh);
    EXPECT_EQ(report.nonManifoldEdges, 1U);
    EXPECT_EQ(report.boundaryEdges, 2U);
}

TEST(InspectMesh, CountsTrianglesWithoutAreaDuplicatesAndUnusedVertices)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.vertices.emplace_back(5, 5, 5);
    mesh.triangles.push_back({3, 3, 1});
    mesh.triangles.push_back({2, 3, 0});
    const MeshReport report = inspectMesh(mesh);
    EXPECT_EQ(report.degenerateTriangles, 1U);
    EXPECT_EQ(report.duplicateTriangles, 1U);
    EXPECT_EQ(report.unusedVertices, 1U);
}

TEST(InspectMesh, CountsThePiecesAndTheHandlesOfAll)
{
    TriangleMesh mesh = builtInMesh("torus");
    test::append(mesh, builtInMesh("torus"));
    test::append(mesh, test::box(5, 6));
    const MeshReport report = inspectMesh(mesh);
    EXPECT_EQ(report.components, 3U);
    EXPECT_EQ(report.genus, 2);
}

TEST(InspectMesh, CountsNoHandleWhereTwoPiecesTouchInAPoint)
{
    TriangleMesh mesh = test::box(0, 1);
    TriangleMesh other = test::box(1, 2);
    test::append(mesh, other);
    for (auto& t : mesh.triangles)
    {
        std::replace(t.begin(), t.end(), std::uint32_t{8}, std::uint32_t{7});
    }
    const MeshReport report = inspectMesh(mesh);
    EXPECT_TRUE(report.closed());
    EXPECT_EQ(report.components, 2U);
    EXPECT_EQ(report.genus, 0);
}

TEST(InspectMesh, ReportsAnEmptyMeshAsOpen)
{
    EXPECT_FALSE(inspectMesh(TriangleMesh{}).closed());
}

} // namespace
} // namespace frostfill

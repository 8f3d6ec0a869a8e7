// SPDX-License-Identifier: MIT
#include "mesh/repair/repair_steps.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <cmath>
#include <limits>

namespace frostfill
{
namespace
{

TEST(RepairMesh, LeavesACleanMeshAsItIs)
{
    const TriangleMesh mesh = builtInMesh("torus");
    const LoadedMesh loaded = repairMesh(mesh, "torus");
    EXPECT_TRUE(loaded.repairs.empty());
    EXPECT_EQ(loaded.mesh.triangles, mesh.triangles);
    EXPECT_EQ(loaded.mesh.vertices, mesh.vertices);
}

TEST(RepairMesh, TurnsInsideOutMeshOutward)
{
    TriangleMesh mesh = builtInMesh("torus");
    test::flipAll(mesh);
    const LoadedMesh loaded = repairMesh(mesh, "torus");
    test::expectOnlyRepair(loaded, "turned 1 piece");
    EXPECT_LT(loaded.asRead.volume, 0);
    EXPECT_EQ(loaded.report.volume, -loaded.asRead.volume);
}

TEST(RepairMesh, TurnsSingleTrianglesToAgreeWithTheirNeighbours)
{
    TriangleMesh mesh = builtInMesh("human");
    const double volume = signedVolume(mesh);
    for (const std::size_t i : {3, 77, 78, 2000})
    {
        test::flip(mesh.triangles[i]);
    }
    const LoadedMesh loaded = repairMesh(mesh, "human");
    test::expectOnlyRepair(loaded, "turned 4 triangles");
    EXPECT_DOUBLE_EQ(loaded.report.volume, volume);
}

TEST(RepairMesh, KeepsACavityWoundInwards)
{
    TriangleMesh mesh = test::box(0, 4);
    TriangleMesh cavity = test::box(1, 3);
    test::flipAll(cavity);
    test::append(mesh, cavity);
    const LoadedMesh loaded = repairMesh(mesh, "hollow");
    EXPECT_TRUE(loaded.repairs.empty());
    EXPECT_EQ(loaded.report.volume, 64.0 - 8.0);
}

TEST(RepairMesh, TurnsACavityInwardsAndASolidInsideItOutwards)
{
    TriangleMesh mesh = test::box(0, 8);
    TriangleMesh core = test::box(3, 5);
    test::flipAll(core);
    test::append(mesh, test::box(1, 7));
    test::append(mesh, core);
    const LoadedMesh loaded = repairMesh(mesh, "shells");
    test::expectOnlyRepair(loaded, "turned 2 pieces");
    EXPECT_EQ(loaded.report.volume, 512.0 - 216.0 + 8.0);
}

TEST(RepairMesh, RemovesDuplicateTriangles)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.triangles.push_back(mesh.triangles[4]);
    const auto& t = mesh.triangles[7];
    mesh.triangles.push_back({t[1], t[2], t[0]});
    const LoadedMesh loaded = repairMesh(mesh, "box");
    test::expectOnlyRepair(loaded, "2 duplicate triangles");
    EXPECT_EQ(loaded.report.triangles, 12U);
}

// Every edge of the two has two triangles that agree, as in a sound mesh.
TEST(RepairMesh, RemovesTwoTrianglesBackToBack)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.vertices.insert(mesh.vertices.end(), {{0.4, 0.4, 0.4}, {0.6, 0.4, 0.4}, {0.5, 0.6, 0.5}});
    mesh.triangles.insert(mesh.triangles.end(), {{8, 9, 10}, {8, 10, 9}});
    const LoadedMesh loaded = repairMesh(mesh, "box");
    EXPECT_EQ(loaded.mesh.triangles, test::box(0, 1).triangles);
    EXPECT_EQ(loaded.mesh.vertices.size(), 8U);
}

TEST(RepairMesh, RemovesADuplicateThatFacesTheOtherWay)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.triangles.push_back(mesh.triangles[4]);
    test::flip(mesh.triangles.back());
    test::expectOnlyRepair(repairMesh(mesh, "box"), "1 duplicate triangle");
}

/// Two boxes with the same vertices on the face between them, which each of them has.
TriangleMesh boxesWithAWallBetween()
{
    TriangleMesh mesh = test::box({0, 0, 0}, {1, 1, 1});
    test::append(mesh, test::box({1, 0, 0}, {2, 1, 1}));
    // The right box's low-x face gets the left one's vertices and the same diagonal.
    for (auto& t : mesh.triangles)
    {
        for (const auto& [own, shared] : {std::pair{8U, 1U}, {10U, 3U}, {12U, 5U}, {14U, 7U}})
        {
            std::replace(t.begin(), t.end(), own, shared);
        }
    }
    return mesh;
}

TEST(RepairMesh, RemovesTheWallBetweenTwoSolidsThatShareIt)
{
    const TriangleMesh mesh = boxesWithAWallBetween();
    ASSERT_EQ(mesh.triangles[20], (std::array<std::uint32_t, 3>{1, 5, 7}));
    const LoadedMesh loaded = repairMesh(mesh, "boxes");
    EXPECT_EQ(loaded.report.components, 1U);
    EXPECT_EQ(loaded.report.triangles, 20U);
    EXPECT_EQ(loaded.report.volume, 2.0);
}

/// Every triangle also wound the other way.
void addBacks(TriangleMesh& mesh)
{
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        mesh.triangles.push_back(mesh.triangles[i]);
        test::flip(mesh.triangles.back());
    }
}

TEST(RepairMesh, KeepsASurfaceThatIsThereFromBothSides)
{
    TriangleMesh mesh = builtInMesh("cube");
    mesh.triangles.erase(mesh.triangles.begin() + 100); // so that nothing would be better than this
    addBacks(mesh);
    const LoadedMesh loaded = repairMesh(mesh, "cube");
    EXPECT_EQ(loaded.repairs[0], "removed 767 duplicate triangles");
    EXPECT_EQ(loaded.report.triangles, 768U);
    EXPECT_EQ(loaded.report.volume, 8.0);
}

TEST(RepairMesh, KeepsAPieceFromBothSidesBesideAWallThatIsCancelled)
{
    TriangleMesh twoSided = builtInMesh("cube");
    twoSided.triangles.erase(twoSided.triangles.begin() + 100);
    addBacks(twoSided);
    for (Eigen::Vector3d& vertex : twoSided.vertices)
    {
        vertex.x() += 9;
    }
    TriangleMesh mesh = boxesWithAWallBetween();
    test::append(mesh, twoSided);
    const LoadedMesh loaded = repairMesh(mesh, "two");
    EXPECT_EQ(loaded.report.triangles, 20U + 768);
    EXPECT_DOUBLE_EQ(loaded.report.volume, 2.0 + 8);
    EXPECT_EQ(loaded.report.components, 2U);
}

TEST(RepairMesh, RemovesTrianglesThatRepeatACorner)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.triangles.push_back({0, 0, 5});
    mesh.triangles.push_back({6, 6, 6});
    test::expectOnlyRepair(repairMesh(mesh, "box"), "removed 2 triangles without area");
}

TEST(RepairMesh, RemovesASliverWithoutOpeningASlit)
{
    // A vertex in the middle of edge 0-3, used by one of the two triangles there; the gap to the
    // other one is filled by a triangle without area.
    TriangleMesh mesh = test::box(0, 1);
    mesh.vertices.emplace_back(0.5, 0.5, 0);
    mesh.triangles[0] = {0, 2, 8};
    mesh.triangles.push_back({8, 2, 3});
    mesh.triangles.push_back({0, 8, 3});
    ASSERT_TRUE(inspectMesh(mesh).closed());
    ASSERT_EQ(inspectMesh(mesh).degenerateTriangles, 1U);
    const LoadedMesh loaded = repairMesh(mesh, "box");
    ASSERT_FALSE(loaded.repairs.empty());
    EXPECT_NE(loaded.repairs[0].find("without area"), std::string::npos);
    EXPECT_EQ(loaded.report.degenerateTriangles, 0U);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.volume, 1.0);
}

TEST(RepairMesh, RemovesUnusedVertices)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.vertices.insert(mesh.vertices.begin(), Eigen::Vector3d(9, 9, 9));
    for (auto& t : mesh.triangles)
    {
        for (auto& corner : t)
        {
            ++corner;
        }
    }
    const LoadedMesh loaded = repairMesh(mesh, "box");
    test::expectOnlyRepair(loaded, "1 unused vertex");
    EXPECT_EQ(loaded.mesh.vertices.size(), 8U);
    EXPECT_EQ(loaded.report.volume, 1.0);
}

TEST(RepairMesh, JoinsSeamsThatMissEachOtherByRounding)
{
    TriangleMesh mesh = test::soup(builtInMesh("human"));
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    {
        mesh.vertices[i].x() += 1e-8 * static_cast<double>(i % 3);
    }
    const LoadedMesh loaded = repairMesh(mesh, "human");
    EXPECT_EQ(loaded.report.vertices, 1111U);
    EXPECT_TRUE(loaded.report.closed());
    ASSERT_FALSE(loaded.repairs.empty());
    EXPECT_NE(loaded.repairs[0].find("joined"), std::string::npos);
}

TEST(RepairMesh, RefusesAMeshWithoutTriangles)
{
    test::expectRefused(ErrorCode::badData, "'nothing' cannot be filled: it has no triangles",
                        [] { (void)repairMesh(TriangleMesh{}, "nothing"); });
}

TEST(RepairMesh, RefusesVerticesThatAreNotFinite)
{
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
        TriangleMesh mesh = test::box(0, 1);
        mesh.vertices[4].y() = bad;
        test::expectRefused(ErrorCode::badData, "vertex 5", [&] { (void)repairMesh(mesh, "box"); });
    }
}

TEST(RepairMesh, RefusesIndicesOutOfRange)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.triangles[2][1] = 8;
    test::expectRefused(ErrorCode::badData, "triangle 3 refers to vertex 9 of 8",
                        [&] { (void)repairMesh(mesh, "box"); });
}

TEST(RepairMesh, RefusesASheetWithoutVolume)
{
    TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    test::expectRefused(ErrorCode::badData, "hole", [&] { (void)repairMesh(sheet, "sheet"); });
    TriangleMesh line{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    test::expectRefused(ErrorCode::badData, "area", [&] { (void)repairMesh(line, "line"); });
}

TEST(RepairMesh, RefusesAnInnerWallAndSaysWhere)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.triangles.push_back({0, 1, 7});
    mesh.triangles.push_back({0, 7, 6});
    test::expectRefused(ErrorCode::badData, "near (0.5 0 0)",
                        [&] { (void)repairMesh(mesh, "box"); });
}

TEST(RepairMesh, TakesPiecesThatPassThroughEachOther)
{
    TriangleMesh mesh = test::box(0, 2);
    test::append(mesh, test::box(1, 3));
    const LoadedMesh loaded = repairMesh(mesh, "boxes");
    EXPECT_TRUE(loaded.repairs.empty());
    const MeshReport report = inspectInterior(loaded.mesh);
    EXPECT_TRUE(report.closed());
    EXPECT_NEAR(report.volume, 15, 15e-4); // 8 + 8 - 1, where the signed volume says 16
    EXPECT_NEAR(loaded.report.volume, 16, 1e-9);
    EXPECT_GT(report.crossedTriangles, 0u);
    const Eigen::AlignedBox3d overlap(Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(2, 2, 2));
    EXPECT_TRUE(overlap.contains(report.firstCrossing)) << report.firstCrossing.transpose();
}

TEST(RepairMesh, TakesEdgesOfFourTrianglesWhoseWindingsCancel)
{
    // Two boxes that share the edge x = y = 1 and its two corners.
    TriangleMesh mesh = test::box(0, 1);
    TriangleMesh other = test::box(0, 1);
    for (Eigen::Vector3d& vertex : other.vertices)
    {
        vertex += Eigen::Vector3d(1, 1, 0);
    }
    test::append(mesh, other);
    weldEqualVertices(mesh);
    EXPECT_EQ(inspectMesh(mesh).nonManifoldEdges, 1u);
    EXPECT_EQ(inspectMesh(mesh).unbalancedEdges, 0u);
    EXPECT_TRUE(inspectMesh(mesh).closed());
    const LoadedMesh loaded = repairMesh(mesh, "boxes");
    EXPECT_NEAR(inspectInterior(loaded.mesh).volume, 2, 1e-3);
}

TEST(RepairMesh, RefusesAOneSidedSurface)
{
    // The six-vertex projective plane: every edge has two triangles, but no winding fits.
    TriangleMesh mesh;
    for (int i = 0; i < 6; ++i)
    {
        mesh.vertices.emplace_back(std::cos(i), std::sin(2.0 * i), 0.3 * i * i);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                      {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
    test::expectRefused(ErrorCode::badData, "one-sided", [&] { (void)repairMesh(mesh, "plane"); });
}

} // namespace
} // namespace frostfill

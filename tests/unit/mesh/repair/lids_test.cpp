// SPDX-License-Identifier: MIT
#include "mesh/connectivity.hpp"
#include "mesh/repair/repair_steps.hpp"
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"
#include "unit/mesh/repair/lathe.hpp"

#include <numbers>

namespace frostfill
{
namespace
{

using test::lathe;
using test::volumeOf;

constexpr LoadMeshOptions kLid{.lid = true};

/// Without the triangles whose corners all satisfy a condition.
template <class Condition>
TriangleMesh without(TriangleMesh mesh, Condition&& condition)
{
    std::erase_if(mesh.triangles,
                  [&](const auto& t)
                  {
                      return std::all_of(t.begin(), t.end(),
                                         [&](auto corner)
                                         { return condition(mesh.vertices[corner]); });
                  });
    return mesh;
}

bool atTop(const Eigen::Vector3d& p)
{
    return p.y() == 1;
}

TriangleMesh openBox(int n = 4)
{
    return without(shapes::box(Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1), n),
                   atTop);
}

std::size_t repairsWith(const LoadedMesh& loaded, const std::string& part)
{
    return static_cast<std::size_t>(std::count_if(
        loaded.repairs.begin(), loaded.repairs.end(),
        [&](const std::string& repair) { return repair.find(part) != std::string::npos; }));
}

TEST(Lids, CloseAnOpenBoxAndAreReported)
{
    const LoadedMesh loaded = repairMesh(openBox(), "box", kLid);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_DOUBLE_EQ(loaded.report.volume, 8);
    EXPECT_DOUBLE_EQ(loaded.report.area, 24);
    EXPECT_EQ(repairsWith(loaded, "put a lid on an opening of 16 edges near (0 1 0): area 4, 20 % "
                                  "of the surface"),
              1U);
    EXPECT_EQ(inspectInterior(loaded.mesh).crossedTriangles, 0U);
}

TEST(Lids, CloseAHalfSphereToItsClosedFormVolume)
{
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i <= 16; ++i)
    {
        const double angle = std::numbers::pi / 2 * i / 16;
        profile.push_back({i == 16 ? 0 : std::cos(angle), std::sin(angle)});
    }
    const LoadedMesh loaded = repairMesh(lathe(profile, 64), "half sphere", kLid);
    ASSERT_TRUE(loaded.report.closed());
    EXPECT_NEAR(loaded.report.volume, volumeOf(profile, 64), 1e-12);
    EXPECT_NEAR(loaded.report.volume, 2 * std::numbers::pi / 3, 0.02);
}

TEST(Lids, OverALongRimAddNoVertex)
{
    // A bust, open below, with more edges at the rim than a lid of least area is sought for.
    const std::vector<std::array<double, 2>> profile = {{0.8, 0}, {0.7, 0.4}, {0.25, 0.6},
                                                        {0.5, 1}, {0.4, 1.4}, {0, 1.5}};
    const TriangleMesh bust = lathe(profile, 1000);
    const LoadedMesh loaded = repairMesh(bust, "bust", kLid);
    ASSERT_TRUE(loaded.report.closed());
    EXPECT_NEAR(loaded.report.volume, volumeOf(profile, 1000), 1e-12);
    EXPECT_EQ(repairsWith(loaded, "an opening of 1000 edges near (0 0 0)"), 1U);
    EXPECT_EQ(loaded.report.triangles, loaded.asRead.triangles + 998);
}

TEST(Lids, CloseALongRimWithCollinearAndReflexCorners)
{
    // The outline of a plus, each of its twelve sides of forty edges.
    std::array<std::vector<double>, 3> planes;
    for (int i = 0; i <= 120; ++i)
    {
        planes[0].push_back(i / 40.0);
        planes[2].push_back(i / 40.0);
    }
    planes[1] = {0, 1};
    const auto inPlus = [](const std::array<int, 3>& cell)
    { return cell[0] / 40 == 1 || cell[2] / 40 == 1; };
    const TriangleMesh open = without(shapes::gridCells(planes, inPlus), atTop);
    const EdgeTable edges(open);
    const auto rims = findRims(edges);
    ASSERT_EQ(rims.size(), 1U);
    ASSERT_EQ(rims[0].size(), 480U);
    EXPECT_EQ(clippedLid(open, edges, rims[0]).size(), 478U);
    const LoadedMesh loaded = repairMesh(open, "plus", kLid);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.report.degenerateTriangles, 0U);
    EXPECT_NEAR(loaded.report.volume, 5, 1e-10);
    EXPECT_NEAR(loaded.report.area, 22, 1e-10);
}

TEST(Lids, CloseARimThatIsNotFlat)
{
    for (const int about : {60, 600})
    {
        const TriangleMesh cup =
            lathe({{0, -1}, {1, -1}, {1, 0}}, about,
                  [](int ring, double angle) { return ring == 2 ? 0.3 * std::cos(2 * angle) : 0; });
        const LoadedMesh loaded = repairMesh(cup, "cup", kLid);
        ASSERT_TRUE(loaded.report.closed());
        // What the lid adds on two sides it takes on the others, more or less: the ears of a long
        // rim follow either the high or the low parts.
        const double most = about > 400 ? 0.15 : 0.02;
        EXPECT_NEAR(loaded.report.volume, std::numbers::pi, most * std::numbers::pi) << about;
        EXPECT_EQ(loaded.report.genus, 0);
    }
}

TEST(Lids, FanOverARimThatCrossesItselfInItsPlane)
{
    // A cone over a figure of eight, of which one loop is larger.
    TriangleMesh cone;
    constexpr std::uint32_t kCorners = 500;
    cone.vertices.emplace_back(0, -1, 0);
    for (std::uint32_t i = 0; i < kCorners; ++i)
    {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / kCorners;
        const double scale = 1 + 0.5 * std::sin(angle);
        cone.vertices.emplace_back(scale * std::sin(angle), 0.2 * std::cos(angle),
                                   0.5 * scale * std::sin(2 * angle));
        cone.triangles.push_back({0, 1 + i, 1 + (i + 1) % kCorners});
    }
    const EdgeTable edges(cone);
    EXPECT_TRUE(clippedLid(cone, edges, findRims(edges).at(0)).empty());
    const LoadedMesh loaded = repairMesh(cone, "cone", kLid);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_EQ(loaded.mesh.vertices.size(), kCorners + 2);
    EXPECT_GT(inspectInterior(loaded.mesh).volume, 0.1);
}

TEST(Lids, CloseTwoRimsOfAPiece)
{
    const TriangleMesh tube = without(openBox(), [](const auto& p) { return p.y() == -1; });
    const LoadedMesh loaded = repairMesh(tube, "tube", kLid);
    EXPECT_EQ(repairsWith(loaded, "put a lid on an opening of 16 edges"), 2U);
    EXPECT_DOUBLE_EQ(loaded.report.volume, 8);
}

/// Adds a wall across the middle of a box of 2 x 2 squares a side. It meets the box at edges of
/// three triangles.
void addInnerWall(TriangleMesh& box)
{
    const auto corner = [&](double y, double z)
    {
        const auto found =
            std::find(box.vertices.begin(), box.vertices.end(), Eigen::Vector3d(0, y, z));
        return static_cast<std::uint32_t>(found - box.vertices.begin());
    };
    const std::vector<std::uint32_t> rim = {corner(-1, -1), corner(-1, 0), corner(-1, 1),
                                            corner(0, 1),   corner(1, 1),  corner(1, 0),
                                            corner(1, -1),  corner(0, -1)};
    const auto middle = static_cast<std::uint32_t>(box.vertices.size());
    box.vertices.emplace_back(0, 0, 0);
    for (std::size_t i = 0; i < rim.size(); ++i)
    {
        box.triangles.push_back({middle, rim[i], rim[(i + 1) % rim.size()]});
    }
}

TEST(Lids, KeepAWallWithinAsAnObstacle)
{
    TriangleMesh mesh = shapes::box(Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1), 2);
    addInnerWall(mesh);
    for (auto& t : mesh.triangles) // one half is wound against the other
    {
        const bool left = std::all_of(t.begin(), t.end(),
                                      [&](auto corner) { return mesh.vertices[corner].x() <= 0; });
        if (left)
        {
            test::flip(t);
        }
    }
    test::expectRefused(ErrorCode::badData, "shared by more than two triangles",
                        [&] { (void)repairMesh(mesh, "box"); });
    test::expectRefused(ErrorCode::badData, "give --lid (frostfill fill box --lid)",
                        [&] { (void)repairMesh(mesh, "box"); });
    const LoadedMesh loaded = repairMesh(mesh, "box", kLid);
    EXPECT_EQ(repairsWith(loaded, "doubled 8 triangles of walls within"), 1U);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_DOUBLE_EQ(loaded.report.volume, 8);
    EXPECT_DOUBLE_EQ(loaded.report.area, 24 + 2 * 4);
}

TEST(Lids, DropAWallWithinThatHasAFreeEdge)
{
    TriangleMesh mesh = openBox(2);
    addInnerWall(mesh);
    const LoadedMesh loaded = repairMesh(mesh, "box", kLid);
    EXPECT_EQ(repairsWith(loaded, "removed 8 triangles of open patches"), 1U);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_DOUBLE_EQ(loaded.report.volume, 8);
}

TEST(Lids, DropAFinBesideAnOpening)
{
    TriangleMesh mesh = openBox(1);
    const auto tip = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(3, -1, 0);
    const auto& t = mesh.triangles[0];
    mesh.triangles.push_back({t[0], t[1], tip}); // a third triangle at an edge
    const LoadedMesh loaded = repairMesh(mesh, "box", kLid);
    EXPECT_EQ(repairsWith(loaded, "removed 1 triangle of open patches that enclose nothing"), 1U);
    EXPECT_DOUBLE_EQ(loaded.report.volume, 8);
}

TEST(Lids, MayCrossTheMesh)
{
    // A post through the bottom of the open box, up through the lid.
    TriangleMesh mesh = openBox();
    test::append(mesh, shapes::box({-0.3, -0.9, -0.3}, {0.35, 2, 0.3}));
    const LoadedMesh loaded = repairMesh(mesh, "box", kLid);
    ASSERT_TRUE(loaded.report.closed());
    const MeshReport report = inspectInterior(loaded.mesh);
    EXPECT_GT(report.crossedTriangles, 0U);
    EXPECT_NEAR(report.volume, 8 + 0.65 * 0.6, 1e-3);
}

TEST(Lids, MakeNoEnvelopeOfASheet)
{
    TriangleMesh sheet = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    const auto refusal = test::errorOf([&] { (void)repairMesh(sheet, "sheet", kLid); });
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->code(), ErrorCode::badData);
    EXPECT_NE(std::string(refusal->what()).find("is the rim of a sheet"), std::string::npos);
    EXPECT_EQ(std::string(refusal->what()).find("--lid"), std::string::npos);
}

TEST(Lids, AreNamedByARefusalOnlyIfTheyHelp)
{
    test::expectRefused(ErrorCode::badData, "% of the surface); give --lid (frostfill fill",
                        [] { (void)repairMesh(openBox(), "box"); });
    TriangleMesh wall = openBox();
    std::erase_if(wall.triangles,
                  [&](const auto& t)
                  {
                      return std::any_of(t.begin(), t.end(),
                                         [&](auto corner)
                                         { return wall.vertices[corner].x() > -1; });
                  });
    const auto refusal = test::errorOf([&] { (void)repairMesh(wall, "wall"); });
    ASSERT_TRUE(refusal);
    EXPECT_EQ(std::string(refusal->what()).find("--lid"), std::string::npos) << refusal->what();
}

TEST(Lids, LeaveWhatIsOneSidedRefused)
{
    TriangleMesh band;
    constexpr std::uint32_t kSteps = 24;
    for (std::uint32_t i = 0; i < kSteps; ++i)
    {
        const double angle = 2 * std::numbers::pi * i / kSteps;
        for (const double w : {-0.3, 0.3})
        {
            const double d = 1 + w * std::cos(angle / 2);
            band.vertices.emplace_back(d * std::cos(angle), w * std::sin(angle / 2),
                                       d * std::sin(angle));
        }
    }
    for (std::uint32_t i = 0; i < kSteps; ++i)
    {
        const bool last = i + 1 == kSteps;
        const std::uint32_t a = 2 * i;
        const std::uint32_t c = last ? 1 : 2 * i + 2;
        const std::uint32_t d = last ? 0 : 2 * i + 3;
        band.triangles.push_back({a, a + 1, d});
        band.triangles.push_back({a, d, c});
    }
    test::expectRefused(ErrorCode::badData, "one-sided",
                        [&] { (void)repairMesh(band, "band", kLid); });
}

TEST(Lids, ChangeNothingOfAClosedMesh)
{
    const LoadedMesh loaded = repairMesh(builtInMesh("torus"), "torus", kLid);
    EXPECT_TRUE(loaded.repairs.empty());
    EXPECT_EQ(loaded.mesh.triangles, builtInMesh("torus").triangles);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
// Vessels whose walls have a thickness: cups, cans, hoppers. The option cavity fills what they
// enclose.
#include "mesh/repair/repair_steps.hpp"
#include "support/shapes.hpp"
#include "unit/mesh/mesh_samples.hpp"
#include "unit/mesh/repair/lathe.hpp"

namespace frostfill
{
namespace
{

using test::lathe;
using test::volumeOf;
using Profile = std::vector<std::array<double, 2>>;

constexpr int kAbout = 48;
constexpr LoadMeshOptions kCavity{.cavity = true};
constexpr LoadMeshOptions kCavityAndLid{.lid = true, .cavity = true};

/// A closed profile, whose ends are one.
TriangleMesh ring(const Profile& profile, int about = kAbout)
{
    TriangleMesh mesh = lathe(profile, about);
    weldEqualVertices(mesh);
    return mesh;
}

/// Outer radius 1, height 2, walls of 0.05, open at the top.
TriangleMesh cup()
{
    return lathe({{0, 0}, {1, 0}, {1, 2}, {0.95, 2}, {0.95, 0.05}, {0, 0.05}}, kAbout);
}

const double kCupVolume = volumeOf({{0.95, 0.05}, {0.95, 2}}, kAbout);

std::string hintOn(const TriangleMesh& mesh)
{
    const LoadedMesh loaded = repairMesh(mesh, "vessel");
    return cavityHint("vessel", {}, loaded);
}

TEST(Cavity, OfACupIsFilledUpToItsRim)
{
    const LoadedMesh loaded = repairMesh(cup(), "cup", kCavityAndLid);
    EXPECT_TRUE(loaded.report.closed());
    EXPECT_NEAR(loaded.report.volume, kCupVolume, 1e-9);
    EXPECT_EQ(loaded.lidTriangles, kAbout - 2U);
    EXPECT_NEAR(loaded.opening.y(), volumeOf({{0.95, 0}, {0.95, 1}}, kAbout), 1e-9);
    EXPECT_EQ(loaded.asRead.triangles, cup().triangles.size());
    EXPECT_EQ(cavityHint("cup", {}, repairMesh(cup(), "cup")),
              "the walls are filled, and not the cavity of volume 5.513 that they enclose; "
              "--cavity --lid fills the cavity");
}

TEST(Cavity, OfACupNeedsALid)
{
    test::expectRefused(ErrorCode::badData, "give --lid",
                        [] { (void)repairMesh(cup(), "cup", kCavity); });
}

TEST(Cavity, OfACupIsFoundWhicheverWayTheCupStands)
{
    for (int i = 0; i < 12; ++i)
    {
        TriangleMesh mesh = cup();
        const Eigen::Matrix3d turn =
            (Eigen::AngleAxisd(0.5 * i, Eigen::Vector3d(1, 0.3 * i, -0.2).normalized()))
                .toRotationMatrix();
        for (Eigen::Vector3d& vertex : mesh.vertices)
        {
            vertex = turn * vertex + Eigen::Vector3d(5, -3, i);
        }
        const LoadedMesh loaded = repairMesh(mesh, "cup", kCavityAndLid);
        EXPECT_NEAR(loaded.report.volume, kCupVolume, 1e-9) << i;
        EXPECT_NE(hintOn(mesh), "") << i;
    }
}

TEST(Cavity, OfAScannedCupWithARoundLipEndsNearTheLip)
{
    // Rows of small triangles, and a lip that is a half circle.
    Profile profile = {{0, 0}, {0.5, 0}};
    const auto add = [&](double radius, double from, double to)
    {
        for (int i = 0; i <= 40; ++i)
        {
            profile.push_back({radius, from + (to - from) * i / 40});
        }
    };
    add(1, 0, 2);
    for (int i = 1; i < 8; ++i)
    {
        const double angle = std::numbers::pi * i / 8;
        profile.push_back({0.97 + 0.03 * std::cos(angle), 2 + 0.03 * std::sin(angle)});
    }
    add(0.94, 2, 0.06);
    profile.push_back({0.5, 0.06});
    profile.push_back({0, 0.06});
    for (const double tilt : {0.0, 0.4})
    {
        TriangleMesh mesh = lathe(profile, 96);
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(tilt, Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
        for (Eigen::Vector3d& vertex : mesh.vertices)
        {
            vertex = turn * vertex;
        }
        const LoadedMesh loaded = repairMesh(mesh, "cup", kCavityAndLid);
        const double whole = volumeOf({{0.94, 0.06}, {0.94, 2}}, 96);
        EXPECT_NEAR(loaded.report.volume, whole, 0.04 * whole) << tilt;
        EXPECT_NE(hintOn(mesh).find("--cavity --lid"), std::string::npos) << tilt;
    }
}

TEST(Cavity, OfASealedCanNeedsNoLid)
{
    const TriangleMesh outer = lathe({{0, 0}, {1, 0}, {1, 2}, {0, 2}}, kAbout);
    const Profile inner = {{0, 0.05}, {0.95, 0.05}, {0.95, 1.95}, {0, 1.95}};
    for (const bool turned : {false, true})
    {
        TriangleMesh can = outer;
        TriangleMesh shell = lathe(inner, kAbout);
        if (turned)
        {
            test::flipAll(shell);
        }
        test::append(can, shell);
        EXPECT_NEAR(repairMesh(can, "can", kCavity).report.volume, volumeOf(inner, kAbout), 1e-9);
        const std::string hint = hintOn(can);
        EXPECT_NE(hint.find("--cavity fills"), std::string::npos) << hint;
    }
}

TEST(Cavity, HoldsTheSolidsInIt)
{
    TriangleMesh can = lathe({{0, 0}, {1, 0}, {1, 2}, {0, 2}}, kAbout);
    test::append(can, lathe({{0, 0.05}, {0.95, 0.05}, {0.95, 1.95}, {0, 1.95}}, kAbout));
    test::append(can, test::box(0.4, 0.6));
    EXPECT_NEAR(repairMesh(can, "can", kCavity).report.volume,
                volumeOf({{0.95, 0.05}, {0.95, 1.95}}, kAbout) - 0.008, 1e-9);
    TriangleMesh mug = cup();
    test::append(mug, test::box(0.4, 0.6));
    EXPECT_NEAR(repairMesh(mug, "mug", kCavityAndLid).report.volume, kCupVolume - 0.008, 1e-9);
}

TEST(Cavity, OfAHopperHasTwoLids)
{
    const Profile inner = {{0.3, 0}, {0.3, 0.5}, {1.5, 2}, {1.5, 3}};
    const TriangleMesh hopper = ring({{0.3, 0},
                                      {0.35, 0},
                                      {0.35, 0.5},
                                      {1.55, 2},
                                      {1.55, 3},
                                      {1.5, 3},
                                      {1.5, 2},
                                      {0.3, 0.5},
                                      {0.3, 0}});
    const LoadedMesh loaded = repairMesh(hopper, "hopper", kCavityAndLid);
    EXPECT_NEAR(loaded.report.volume, volumeOf(inner, kAbout), 1e-9);
    EXPECT_GT(loaded.opening.y(), 6);
    EXPECT_NE(hintOn(hopper).find("--cavity --lid"), std::string::npos);
}

TEST(Cavity, OfASpoolIsNotTheGapBetweenItsFlanges)
{
    const TriangleMesh spool = lathe({{0, 0},
                                      {2.2, 0},
                                      {2.2, 0.05},
                                      {1, 0.05},
                                      {1, 1.85},
                                      {2.2, 1.85},
                                      {2.2, 1.9},
                                      {0.95, 1.9},
                                      {0.95, 0.1},
                                      {0, 0.1}},
                                     kAbout);
    EXPECT_NEAR(repairMesh(spool, "spool", kCavityAndLid).report.volume,
                volumeOf({{0.95, 0.1}, {0.95, 1.9}}, kAbout), 1e-9);
}

TEST(Cavity, IsNotInSolidsAndPlates)
{
    for (const std::string& name : builtInMeshNames())
    {
        EXPECT_EQ(hintOn(builtInMesh(name)), "") << name;
    }
    EXPECT_EQ(hintOn(shapes::torus(1, 0.1)), "");
    const TriangleMesh bracket =
        shapes::gridCells({{{0, 0.05, 1}, {0, 0.05, 1}, {0, 1}}}, [](const std::array<int, 3>& cell)
                          { return cell[0] == 0 || cell[1] == 0; });
    EXPECT_EQ(hintOn(bracket), "");
    test::expectRefused(ErrorCode::badData, "its walls enclose no cavity",
                        [] { (void)repairMesh(builtInMesh("sphere"), "sphere", kCavity); });
}

} // namespace
} // namespace frostfill

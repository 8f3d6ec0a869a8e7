// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/packing.hpp>

#include <gtest/gtest.h>

namespace frostfill
{
namespace
{

using test::expectError;
using test::writeFile;

class PackingFile : public ::testing::Test
{
protected:
    [[nodiscard]] Packing read(const std::string& text, double radius = 0) const
    {
        writeFile(folder_ / "file", text);
        return readPacking(folder_ / "file", radius);
    }
    void expectTheTwo(const Packing& packing) const
    {
        ASSERT_EQ(packing.centres.size(), 2U) << packing.format;
        EXPECT_EQ(packing.centres[0], Eigen::Vector3d(0.5, -1, 2)) << packing.format;
        EXPECT_EQ(packing.centres[1], Eigen::Vector3d(1, 2, -3e-3)) << packing.format;
        EXPECT_EQ(packing.radii, (std::vector<double>{0.25, 0.5})) << packing.format;
    }
    void expectRefused(const std::string& text, const std::string& line,
                       const std::string& what) const
    {
        expectError(
            ErrorCode::badData, [&] { (void)read(text); }, "file, line " + line + ":", what);
    }
    test::TemporaryFolder folder_;
};

TEST_F(PackingFile, IsReadAsATableWithAnySeparatorAndOrderOfColumns)
{
    expectTheTwo(read("x,y,z,radius\n0.5,-1,2,0.25\n1,2,-3e-3,0.5\n"));
    expectTheTwo(read("id;Radius;x;y;z\r\n7;0.25;0.5;-1;2\r\n8;0.5;1;2;-3e-3\r\n"));
    expectTheTwo(read("# z x y diameter name\n2 0.5 -1 0.5 a\n\n-3e-3 1 2 +1 b\n"));
    expectTheTwo(read("\xEF\xBB\xBF\"x\",\"y\",\"z\",\"r\"\n0.5,-1,2,0.25\n1, 2, -3e-3, 0.5"));
}

TEST_F(PackingFile, IsReadAsExtendedXyzUpToItsLastMoment)
{
    expectTheTwo(read("1\nfirst\nA 9 9 9 1\n2\nLattice=\"1 0 0 0 1 0 0 0 1\" "
                      "Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1 Time=2\n"
                      "A 0.5 -1 2 0 0 0 0.25\nA 1 2 -3e-3 0 0 0 0.5\n",
                      1));
    const Packing plain = read("2\nplain\nA 0.5 -1 2\nA 1 2 3\n", 0.125);
    EXPECT_EQ(plain.radii, (std::vector<double>{0.125, 0.125}));
}

TEST_F(PackingFile, IsReadAsALammpsDumpUpToItsLastMoment)
{
    const std::string first = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\n"
                              "ITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
                              "ITEM: ATOMS id type x y z radius\n1 1 9 9 9 1\n";
    expectTheTwo(read(first + "ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n2\n"
                              "ITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
                              "ITEM: ATOMS id type xu yu zu diameter\n"
                              "1 1 0.5 -1 2 0.5\n2 1 1 2 -3e-3 1.0\n"));
}

TEST_F(PackingFile, SaysWhichSpheresRest)
{
    const Packing packing =
        read("x,y,z,radius,state\n0,0,0,1,running\n0,0,0,1,frozen\n0,0,0,1,discarded\n0,0,0,1,0\n");
    EXPECT_EQ(packing.atRest, (std::vector<bool>{false, true, true, false}));
    EXPECT_EQ(read("x,y,z,radius\n0,0,0,1\n").atRest, (std::vector<bool>{true}));
}

TEST_F(PackingFile, IsRefusedWithTheLineOfItsFault)
{
    expectRefused("x,y,radius\n1,2,3\n", "1", "no column z");
    expectRefused("x,y,z\n1,2,3\n", "1", "--radius");
    expectRefused("x,y,z,radius\n1,2,3,4\n1,two,3,4\n", "3", "'two' is no number");
    expectRefused("x,y,z,radius\n1,2,3,4\n1,2\n", "3", "2 values, where 4 are needed");
    expectRefused("3\nProperties=pos:R:3:radius:R:1\n1 2 3 4\n", "3", "ends before its 3 spheres");
    expectRefused("ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id xs ys zs radius\n1 0 0 0 1\n", "3",
                  "dump x y z instead");
    expectRefused("ITEM: NUMBER OF ATOMS\nmany\n", "2", "'many' is no number of spheres");
    expectRefused("99999999999999999999\nx\n", "1", "is no number of spheres");
    expectError(
        ErrorCode::badData, [&] { (void)read("x,y,z,radius\n"); }, "has no spheres");
    expectError(
        ErrorCode::badData, [&] { (void)read(""); }, "ends before its heading");
    expectError(
        ErrorCode::inputMissing, [&] { (void)readPacking(folder_ / "missing"); }, "missing");
}

TEST_F(PackingFile, IsJudgedByOverlapsWallsAndSupport)
{
    // A cube from -1 to 1. One sphere on the floor, one above it 0.1 too deep, one in the air, one
    // in the wall, one outside.
    const Packing packing = read("x,y,z,radius\n0,-0.75,0,0.25\n0,-0.275,0,0.25\n"
                                 "0.5,0.5,0.5,0.25\n-0.95,0.5,0,0.2\n3,0,0,0.25\n");
    const QualityReport quality = judgePacking(loadMesh("cube").mesh, packing, Axis::y);
    EXPECT_NEAR(quality.maxOverlap, 0.1, 1e-9);
    EXPECT_NEAR(quality.maxWallOverlap, 0.75, 1e-9);
    EXPECT_EQ(quality.centresOutside, 1U);
    EXPECT_EQ(quality.notFinite, 0U);
    EXPECT_GE(quality.unsupported, 2U);
    EXPECT_NEAR(quality.meshVolume, 8, 1e-9);
}

TEST_F(PackingFile, OfARunIsJudgedAsTheRunItself)
{
    FillRequest request;
    request.scene = presetScene(Preset::fast, "cube");
    request.scene.spheres.count = 60;
    request.scene.object.up = Axis::z;
    request.scene.frames.enabled = false;
    request.scene.frames.keepRun = true;
    request.scene.frames.duration = 0.5;
    request.directory = folder_ / "run";
    const FillResult run = fill(request);
    ASSERT_FALSE(run.failure);
    const auto expectTheSame = [&](const Packing& packing)
    {
        ASSERT_TRUE(packing.mesh && packing.up);
        EXPECT_EQ(*packing.up, Axis::z);
        const QualityReport quality = judgePacking(*packing.mesh, packing, *packing.up);
        EXPECT_EQ(quality.maxOverlap, run.quality.maxOverlap);
        EXPECT_EQ(quality.maxWallOverlap, run.quality.maxWallOverlap);
        EXPECT_EQ(quality.unsupported, run.quality.unsupported);
        EXPECT_EQ(quality.centresOutside, 0U);
        EXPECT_EQ(quality.sphereVolume, run.quality.sphereVolume);
    };
    expectTheSame(readPacking(folder_ / "run"));
    expectTheSame(readPacking(folder_ / "run/run.frost"));
    std::filesystem::remove(folder_ / "run/run.frost");
    expectTheSame(readPacking(folder_ / "run"));
}

TEST_F(PackingFile, OfARunWithRollingFrictionIsJudgedWithIt)
{
    FillRequest request;
    request.scene = presetScene(Preset::fast, "cube");
    request.scene.spheres.radius = 0.05;
    request.scene.spheres.count = 60;
    request.scene.spheres.inlets = {{{0, -0.3, 0}, 0.15}};
    request.scene.motion.mode = Motion::granular;
    request.scene.rest.mode = Rest::joint;
    request.scene.rest.friction = 0.6;
    request.scene.rest.rollingFriction = 0.3;
    request.scene.judge.friction = 0.6;
    request.scene.frames.enabled = false;
    request.scene.frames.keepRun = true;
    request.directory = folder_ / "run";
    const FillResult result = fill(request);
    ASSERT_FALSE(result.failure);
    ASSERT_TRUE(result.quality.equilibrium);
    EXPECT_EQ(result.quality.equilibrium->unbalanced, 0U);

    const Packing heap = readPacking(folder_ / "run");
    EXPECT_EQ(heap.rollingFriction, 0.3);
    JudgeSettings judge;
    judge.friction = 0.6;
    EXPECT_EQ(judgePacking(*heap.mesh, heap, Axis::y, judge).equilibrium->unbalanced, 0U);
    judge.rollingFriction = 0;
    EXPECT_GT(judgePacking(*heap.mesh, heap, Axis::y, judge).equilibrium->unbalanced, 0U)
        << "spheres roll off a heap";
}

} // namespace
} // namespace frostfill

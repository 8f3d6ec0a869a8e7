// SPDX-License-Identifier: MIT
// Open and broken meshes on the command line: --lid, --wrap, object.unite.
#include "fault/program.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

namespace frostfill
{
namespace
{

using test::Answer;
using test::readFile;
using test::writeFile;
namespace fs = std::filesystem;

/// A cube of edge 2 without its top; and two cubes that overlap.
class OpenMeshes : public ::testing::Test
{
protected:
    OpenMeshes()
    {
        writeFile(folder_ / "tub.obj", "v -1 -1 -1\nv 1 -1 -1\nv 1 -1 1\nv -1 -1 1\n"
                                       "v -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\n"
                                       "f 1 2 3 4\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
        std::string cubes;
        for (const double low : {0.0, 0.5})
        {
            for (int i = 0; i < 8; ++i)
            {
                cubes += fmt::format("v {} {} {}\n", low + (i & 1), low + ((i & 2) >> 1),
                                     low + ((i & 4) >> 2));
            }
        }
        for (const int first : {1, 9})
        {
            for (const auto& face :
                 {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                  std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}})
            {
                cubes += fmt::format("f {} {} {} {}\n", first + face[0], first + face[1],
                                     first + face[2], first + face[3]);
            }
        }
        writeFile(folder_ / "cubes.obj", cubes);
    }
    [[nodiscard]] Answer run(const std::string& arguments) const
    {
        return test::runProgram(arguments, folder_.path(), "FROSTFILL_WRAP=/nowhere/wrap");
    }
    void expectRefused(const std::string& arguments, int code, const std::string& part) const
    {
        const Answer answer = run(arguments);
        EXPECT_EQ(answer.code, code) << arguments << "\n" << answer.errors;
        EXPECT_EQ(std::count(answer.errors.begin(), answer.errors.end(), '\n'), 1) << answer.errors;
        EXPECT_NE(answer.errors.find(part), std::string::npos) << answer.errors;
    }
    test::TemporaryFolder folder_;
};

TEST_F(OpenMeshes, AreRefusedWithTheOptionThatHelps)
{
    expectRefused("fill tub.obj --count 5 --frames none", 65,
                  "give --lid (frostfill fill tub.obj --lid), or close it");
}

TEST_F(OpenMeshes, FillWithALidAndTheSummaryRepeatsIt)
{
    const Answer answer = run("fill tub.obj --lid --count 20 --frames none --out a");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.errors.find("put a lid on an opening of 4 edges"), std::string::npos)
        << answer.errors;
    const auto first = nlohmann::json::parse(readFile(folder_ / "a/summary.json"));
    EXPECT_EQ(first["scene"]["object"]["lid"], true);
    EXPECT_EQ(first["scene"]["object"]["wrap"], nullptr);
    EXPECT_NEAR(first["error"]["volume_mesh"], 8, 1e-12);
    ASSERT_EQ(run("fill a/summary.json --out b --quiet").code, 0);
    const auto second = nlohmann::json::parse(readFile(folder_ / "b/summary.json"));
    EXPECT_EQ(first["state_hash"], second["state_hash"]);
}

TEST_F(OpenMeshes, AreClosedByAFileWithTheirLid)
{
    fs::create_directory(folder_ / "tub");
    fs::copy(folder_ / "tub.obj", folder_ / "tub/wall.obj");
    writeFile(folder_ / "tub/lid.obj", "v -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\nf 1 4 3 2\n");
    writeFile(folder_ / "tub/scene.toml", "object.mesh = 'lid.obj+wall.obj'\n");
    std::vector<std::string> hashes;
    for (const std::string mesh :
         {"tub", "tub/lid.obj tub/wall.obj", "out/summary.json", "tub/scene.toml"})
    {
        const Answer answer = run(
            "fill " + mesh + " --out out --overwrite --count 20 --seed 1 --frames none --quiet");
        ASSERT_EQ(answer.code, 0) << answer.errors;
        const auto summary = nlohmann::json::parse(readFile(folder_ / "out/summary.json"));
        EXPECT_NEAR(summary["error"]["volume_mesh"], 8, 1e-12);
        hashes.push_back(summary["state_hash"]);
    }
    EXPECT_EQ(std::count(hashes.begin(), hashes.end(), hashes[0]), 4);
    EXPECT_NE(run("mesh tub/lid.obj tub/wall.obj").output.find("can be filled"), std::string::npos);
    expectRefused("fill tub.obj none.obj --count 3", 66, "there is no file 'none.obj'");
    expectRefused("fill torus tub.obj --count 3", 66, "there is no file 'torus': give one mesh");
    EXPECT_EQ(run("fill tub/lid.obj tub/wall.obj --count 3 --frames none --quiet").code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "output/lid/summary.json")); // the name of the first
}

TEST_F(OpenMeshes, KeepTheNamesOfTheirFilesInExports)
{
    // Wound in any way, so that repair has to change them.
    writeFile(folder_ / "bottom plate.obj", "v -1 -1 -1\nv 1 -1 -1\nv 1 -1 1\nv -1 -1 1\n"
                                            "f 1 2 3 4\n");
    writeFile(folder_ / "wall.obj", "v -1 -1 -1\nv 1 -1 -1\nv 1 -1 1\nv -1 -1 1\n"
                                    "v -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\n"
                                    "f 1 2 6 5\nf 2 6 7 3\nf 3 7 8 4\nf 1 5 8 4\n");
    writeFile(folder_ / "lid.obj", "v -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\nf 1 2 3 4\n");
    const std::string size = " --radius 0.3 --count 20 --frames last --size 64x48 --overwrite ";
    ASSERT_EQ(run("fill lid.obj 'bottom plate.obj' wall.obj --out a --quiet" + size).code, 0);
    for (const char* file : {"lid.obj", "bottom plate.obj", "wall.obj"})
    {
        fs::rename(folder_ / file, folder_ / (std::string("moved ") + file));
    }
    ASSERT_EQ(run("export a --to openfoam,liggghts,lammps-dump --quiet").code, 0);
    const std::string flow = readFile(folder_ / "a/export/openfoam/0/U");
    EXPECT_NE(flow.find("    bottom_plate { type surfaceNormalFixedValue; refValue uniform -"),
              std::string::npos)
        << flow;
    EXPECT_NE(flow.find("    lid { type zeroGradient; }\n    wall { type noSlip; }\n"),
              std::string::npos);
    EXPECT_EQ(flow.find("outlet"), std::string::npos);
    const std::string script = readFile(folder_ / "a/export/liggghts.in");
    EXPECT_NE(script.find("mesh n_meshes 3 meshes mesh_lid mesh_bottom_plate mesh_wall\n"),
              std::string::npos)
        << script;
    EXPECT_NE(run("export a --to liggghts").errors.find("liggghts"), std::string::npos);

    ASSERT_EQ(run("import a/export/spheres.dump --out b --quiet "
                  "--mesh 'moved wall.obj+moved bottom plate.obj+moved lid.obj'")
                  .code,
              0);
    EXPECT_EQ(run("export b --to stl-bed --ascii --quiet").code, 0);
    EXPECT_NE(readFile(folder_ / "b/export/bed.stl").find("\nsolid moved_lid\n"),
              std::string::npos);

    const std::string open = "fill 'moved wall.obj' 'moved bottom plate.obj' --lid --out c --quiet";
    ASSERT_EQ(run(open + size).code, 0);
    for (const char* lids : {"", "--lids"})
    {
        EXPECT_EQ(run(std::string("export c --to liggghts --quiet --overwrite ") + lids).code, 0);
        EXPECT_EQ(fs::exists(folder_ / "c/export/liggghts_lids.stl"), *lids != '\0');
        EXPECT_TRUE(fs::exists(folder_ / "c/export/liggghts_moved_wall.stl"));
    }
    EXPECT_EQ(run("export c --to openfoam --quiet").code, 0);
    EXPECT_NE(readFile(folder_ / "c/export/openfoam/0/U").find("    outlet { type zeroGradient; }"),
              std::string::npos);
}

TEST_F(OpenMeshes, FillByASceneThatAsksForALid)
{
    writeFile(folder_ / "scene.toml", "[object]\nmesh = \"tub.obj\"\nlid = true\nwrap = \"none\"\n"
                                      "unite = false\n[spheres]\ncount = 5\n"
                                      "[frames]\nwhich = \"none\"\n");
    EXPECT_EQ(run("fill scene.toml --out a --quiet").code, 0);
}

TEST_F(OpenMeshes, NeedAProgramForASkinOrAUnion)
{
    expectRefused("fill tub.obj --wrap auto --count 5 --frames none", 69,
                  "-DFROSTFILL_WITH_CGAL=ON");
    expectRefused("fill cubes.obj --set object.unite=true --count 5 --frames none", 69,
                  "FROSTFILL_WRAP");
    expectRefused("fps tub.obj --set object.wrap=0.2 --no-render --quiet", 69, "frostfill-wrap");
}

TEST_F(OpenMeshes, AlphaMayBeLeftOutBeforeAnotherArgument)
{
    expectRefused("fill --wrap auto tub.obj --count 5 --frames none", 69, "'tub.obj'");
    expectRefused("fill tub.obj --wrap auto --lid --frames none", 69, "'tub.obj'");
    expectRefused("fill tub.obj --wrap -1", 64,
                  "--wrap is '-1', but it must be a number from 0 to");
}

TEST_F(OpenMeshes, TheCommandMeshTellsWhatEachOptionWouldDo)
{
    const Answer open = run("mesh tub.obj");
    EXPECT_EQ(open.code, 65);
    EXPECT_NE(open.output.find("with --lid                          volume 8, area 24\n"),
              std::string::npos)
        << open.output;
    EXPECT_NE(open.output.find(
                  "with --wrap auto                    the program frostfill-wrap is missing"),
              std::string::npos)
        << open.output;

    const Answer crossing = run("mesh cubes.obj");
    EXPECT_EQ(crossing.code, 0) << crossing.errors;
    EXPECT_NE(crossing.output.find("obstacles, which --set object.unite=true removes"),
              std::string::npos);
    EXPECT_NE(crossing.output.find("with --lid                          changes nothing"),
              std::string::npos)
        << crossing.output;
    EXPECT_EQ(crossing.output.find("missing"), std::string::npos) << "it can be filled as it is";

    EXPECT_EQ(run("mesh torus").output.find("with --"), std::string::npos);
}

TEST_F(OpenMeshes, TheCommandMeshWritesTheLiddedMesh)
{
    const Answer answer = run("mesh tub.obj --lid --repair closed.ply");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(run("mesh closed.ply").output.find("volume      8\n"), std::string::npos);
}

/// A cup with a wall: outer radius 1, height 2 along an axis; inner radius 0.9, floor at 0.1.
std::string cup(char up)
{
    constexpr int kAbout = 32;
    const std::array<std::array<double, 2>, 6> profile = {
        {{0, 0}, {1, 0}, {1, 2}, {0.9, 2}, {0.9, 0.1}, {0, 0.1}}};
    std::string text;
    for (const auto& [radius, height] : profile)
    {
        for (int i = 0; i < kAbout; ++i)
        {
            const double x = radius * std::cos(2 * std::numbers::pi * i / kAbout);
            const double y = radius * std::sin(2 * std::numbers::pi * i / kAbout);
            text += up == 'z' ? fmt::format("v {} {} {}\n", x, y, height)
                              : fmt::format("v {} {} {}\n", y, height, x);
        }
    }
    for (int ring = 0; ring < 5; ++ring)
    {
        for (int i = 0; i < kAbout; ++i)
        {
            const int a = ring * kAbout + i + 1;
            const int b = ring * kAbout + (i + 1) % kAbout + 1;
            text += fmt::format("f {} {} {} {}\n", a, b, b + kAbout, a + kAbout);
        }
    }
    return text;
}

TEST_F(OpenMeshes, TheWallOfACupIsFilledWithAHint)
{
    writeFile(folder_ / "cup.obj", cup('y'));
    const Answer answer = run("fill cup.obj --radius 0.04 --count 5 --frames none --out a");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_NE(answer.errors.find("the walls are filled, and not the cavity"), std::string::npos)
        << answer.errors;
    EXPECT_NE(answer.errors.find("; --cavity --lid fills the cavity\n"), std::string::npos);
    EXPECT_NE(run("mesh cup.obj").output.find("--cavity --lid fills the cavity\n"),
              std::string::npos);
}

TEST_F(OpenMeshes, ABuiltInContainerWithAHoleIsFilledWithoutAHint)
{
    const Answer answer = run("fill annulus:2,1.8,4 --count 5 --frames none --out a");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    EXPECT_EQ(answer.errors.find("cavity"), std::string::npos) << answer.errors;
    EXPECT_EQ(run("mesh annulus:2,1.8,4").output.find("cavity"), std::string::npos);
}

TEST_F(OpenMeshes, TheCavityOfACupIsFilledAndItsLidIsNoWall)
{
    writeFile(folder_ / "cup.obj", cup('y'));
    const Answer answer = run("fill cup.obj --cavity --lid --radius 0.1 --count 200 --frames last "
                              "--size 64x48 --out a");
    ASSERT_EQ(answer.code, 0) << answer.errors;
    EXPECT_EQ(answer.errors.find("--cavity --lid fills"), std::string::npos) << answer.errors;
    std::ifstream table(folder_ / "a/spheres.csv");
    std::string line;
    std::getline(table, line);
    std::size_t spheres = 0;
    for (; std::getline(table, line); ++spheres)
    {
        std::array<double, 5> at{}; // id, group, x, y, z
        std::stringstream numbers(line);
        for (std::string cell; double& number : at)
        {
            std::getline(numbers, cell, ',');
            number = std::stod(cell);
        }
        ASSERT_LT(std::hypot(at[2], at[4]), 0.8 + 1e-6) << line;
        ASSERT_GT(at[3], 0.2 - 1e-6) << line;
        ASSERT_LT(at[3], 1.9 + 1e-6) << line;
    }
    EXPECT_EQ(spheres, 200U);
    const auto facets = [&](const std::string& options)
    {
        EXPECT_EQ(run("export a --to liggghts --overwrite --quiet --out b " + options).code, 0);
        const std::string stl = readFile(folder_ / "b/liggghts_walls.stl");
        std::size_t count = 0;
        for (std::size_t at = 0; (at = stl.find("endfacet", at)) != std::string::npos; ++at)
        {
            ++count;
        }
        return count;
    };
    EXPECT_EQ(facets(""), 32U * 3);
    EXPECT_EQ(facets("--lids"), 32U * 3 + 30);
}

TEST_F(OpenMeshes, AnOpeningThatDoesNotPointUpIsSaid)
{
    writeFile(folder_ / "cup.obj", cup('z'));
    const std::string command = "fill cup.obj --cavity --lid --radius 0.2 --count 5 --frames none "
                                "--out a --overwrite ";
    EXPECT_NE(run(command).errors.find("the largest opening faces z, and y is up; if the opening "
                                       "is the top, give --up z\n"),
              std::string::npos);
    EXPECT_EQ(run(command + "--up z").errors.find("largest opening"), std::string::npos);
}

TEST_F(OpenMeshes, AMeshThatLiesOrMayHaveMillimetresIsTold)
{
    const auto said = [&](const std::string& mesh)
    { return run("fill " + mesh + " --count 5 --frames none --out a --overwrite").errors; };
    EXPECT_NE(said("cylinder:1,4 --up z")
                  .find("z is up, and the mesh has a flat foot where y is "
                        "least; if it stands on that, give --up y\n"),
              std::string::npos);
    EXPECT_NE(said("box:200,100,300")
                  .find("the mesh is 300 m large; if its unit is the "
                        "millimetre, give --units mm\n"),
              std::string::npos);
    for (const char* fine : {"cylinder:1,4", "box:2,1,3 --up z", "torus", "human", "sphere",
                             "box:200,100,300 --units mm"})
    {
        const std::string text = said(fine);
        EXPECT_EQ(text.find("give --up"), std::string::npos) << text;
        EXPECT_EQ(text.find("give --units"), std::string::npos) << text;
    }
}

TEST_F(OpenMeshes, AStopWhileASkinIsMadeEndsBothProgramsAtOnce)
{
    writeFile(folder_ / "wrap", "#!/bin/sh\necho $$ >pid\nexec sleep 60\n");
    fs::permissions(folder_ / "wrap", fs::perms::owner_all);
    const Answer answer = test::runProgram(
        "fill tub.obj --wrap auto --frames none --out a & process=$!; until test -s pid; "
        "do sleep 0.05; done; kill -TERM $process; wait $process; code=$?; sleep 0.3; "
        "case $(cut -d' ' -f3 /proc/$(cat pid)/stat 2>&-) in ''|Z) ;; *) code=1 ;; esac; "
        "exit $code",
        folder_.path(), "FROSTFILL_WRAP=./wrap");
    EXPECT_EQ(answer.code, 75) << answer.errors;
    EXPECT_NE(answer.errors.find("stopped before the run began; nothing was written"),
              std::string::npos)
        << answer.errors;
    EXPECT_FALSE(fs::exists(folder_ / "a"));
}

TEST_F(OpenMeshes, AUnionFillsWithoutWallsInside)
{
#ifdef FROSTFILL_WRAP_PROGRAM
    const Answer answer =
        test::runProgram("fill cubes.obj --set object.unite=true --count 20 --frames none --out a",
                         folder_.path(), "FROSTFILL_WRAP='" FROSTFILL_WRAP_PROGRAM "'");
    EXPECT_EQ(answer.code, 0) << answer.errors;
    const auto summary = nlohmann::json::parse(readFile(folder_ / "a/summary.json"));
    EXPECT_NEAR(summary["error"]["volume_mesh"], 1.875, 1e-12);
    EXPECT_EQ(summary["mesh"]["crossed_triangles"], 0);
#else
    GTEST_SKIP() << "built without FROSTFILL_WITH_CGAL";
#endif
}

} // namespace
} // namespace frostfill

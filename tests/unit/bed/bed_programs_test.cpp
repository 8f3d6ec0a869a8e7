// SPDX-License-Identifier: MIT
// Geometry of a run, read by the programs that it is meant for, where they are installed.
#include "output/stl_text.hpp"
#include "support/expect_error.hpp"
#include "unit/export/exported_run.hpp"

#include <frostfill/export.hpp>
#include <frostfill/fill.hpp>
#include <frostfill/mesh.hpp>
#include <frostfill/packing.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;
using test::readFile;

class BedFiles : public ::testing::Test
{
protected:
    BedFiles() { fill("cube", 0.28); }
    void fill(const char* object, double radius) const
    {
        Scene scene = presetScene(Preset::fast, object);
        scene.spheres.count = 20;
        scene.spheres.radius = radius;
        test::recordRun(scene, folder_ / "run.frost", 20);
    }
    void write(ExportFormat format, const std::string& contacts = "shrink:0.99",
               std::size_t resolution = 4, bool ascii = false) const
    {
        ExportRequest request;
        request.run = folder_.path();
        request.format = format;
        request.out = folder_ / "out";
        request.overwrite = true;
        request.bed.voxels = 32;
        request.bed.cell = format == ExportFormat::gmsh ? 0.25 : 0.5;
        request.bed.ascii = ascii;
        request.bed.resolution = resolution;
        parseContacts(contacts, request.bed);
        exportRun(request);
    }
    /// Of a shell in the folder of the files; what it says is in said.txt.
    [[nodiscard]] int run(const std::string& command) const
    {
        const std::string line =
            fmt::format("cd '{}' && ( {} ) > said.txt 2>&1", (folder_ / "out").string(), command);
        return std::system(line.c_str()); // NOLINT(cert-env33-c): of our own words
    }
    [[nodiscard]] std::string said() const { return readFile(folder_ / "out/said.txt"); }
    [[nodiscard]] bool has(const std::string& text) const
    {
        return said().find(text) != std::string::npos;
    }
    static bool isThere(const char* command)
    {
        return std::system(fmt::format("{} >/dev/null 2>&1", command).c_str()) == 0; // NOLINT
    }
    test::TemporaryFolder folder_;
};

/// Debian's OpenFOAM wants to be told where it is.
constexpr const char* kOpenFoam = "export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}; ";

TEST_F(BedFiles, OfStlAreReadBackAsAClosedSurfaceOfTheStatedVolume)
{
    for (const bool ascii : {false, true})
    {
        write(ExportFormat::stlBed, "caps:0.05", 4, ascii);
        const auto summary = nlohmann::json::parse(readFile(folder_ / "out/bed.stl.json"));
        const TriangleMesh mesh = readMesh(folder_ / "out/bed.stl");
        const MeshReport report = inspectMesh(mesh);
        EXPECT_TRUE(report.closed());
        EXPECT_EQ(report.nonManifoldEdges, 0U);
        EXPECT_EQ(report.triangles, summary["triangles"].get<std::size_t>());
        EXPECT_NEAR(report.volume, summary["free_volume"], 1e-6);
        EXPECT_NEAR(report.volume / 8, summary["porosity_of_surface"], 1e-6);
        EXPECT_NEAR(summary["porosity_exact"], 1 - 20 * 4 * M_PI / 3 * 0.28 * 0.28 * 0.28 / 8,
                    1e-9);
    }
    const std::string text = readFile(folder_ / "out/bed.stl");
    for (const char* patch : {"inlet", "outlet", "wall", "spheres"})
    {
        EXPECT_NE(text.find(fmt::format("\nendsolid {}\n", patch)), std::string::npos);
    }
}

TEST_F(BedFiles, OfStlAreClosedAndNotSelfIntersectingForOpenFoam)
{
    if (!isThere("which surfaceCheck"))
    {
        GTEST_SKIP() << "surfaceCheck is not installed";
    }
    for (const auto& [object, radius] : {std::pair{"cube", 0.28}, {"torus", 0.1}})
    {
        fill(object, radius);
        for (const char* contacts : {"shrink:0.99", "caps:0.02"})
        {
            SCOPED_TRACE(fmt::format("{} {}", object, contacts));
            write(ExportFormat::stlBed, contacts);
            const auto summary = nlohmann::json::parse(readFile(folder_ / "out/bed.stl.json"));
            EXPECT_EQ(run(std::string(kOpenFoam) + "surfaceCheck bed.stl -checkSelfIntersection"),
                      0);
            EXPECT_TRUE(has("Surface has no illegal triangles")) << said();
            EXPECT_TRUE(has("Surface is closed. All edges connected to two faces"));
            EXPECT_TRUE(has("Surface is not self-intersecting"));
        }
    }
}

TEST_F(BedFiles, AreMeshedByGmsh)
{
    if (!isThere("which gmsh"))
    {
        GTEST_SKIP() << "gmsh is not installed";
    }
    const std::string mesh =
        "gmsh -3 {0}.geo -format msh2 -o {0}.msh && /usr/bin/python3 '" FROSTFILL_BED_READERS
        "/volume_of_gmsh.py' {0}.msh {1} {2} {3}";
    write(ExportFormat::gmsh);
    // Facets of a mesh as coarse as gmsh makes it cut off some of each sphere.
    EXPECT_EQ(
        run(fmt::format(fmt::runtime(mesh), "bed", "bed.geo.json", "porosity_of_geometry", "0.03")),
        0)
        << said();
    for (const char* contacts : {"shrink:0.99", "caps:0.05"})
    {
        // As text: gmsh tells the free space from the spheres by the solids that bound it.
        write(ExportFormat::stlBed, contacts, 4, true);
        test::writeFile(folder_ / "out/stl.geo", "Merge \"bed.stl\"; s() = Surface{:};\n"
                                                 "Surface Loop(1) = {s()}; Volume(1) = {1};\n");
        EXPECT_EQ(run(fmt::format(fmt::runtime(mesh), "stl", "bed.stl.json", "porosity_of_surface",
                                  "1e-5")),
                  0)
            << said();
    }
}

TEST_F(BedFiles, OfOpenFoamAreMeshedWithTheirPatches)
{
    if (!isThere("which snappyHexMesh"))
    {
        GTEST_SKIP() << "snappyHexMesh is not installed";
    }
    write(ExportFormat::openFoam);
    EXPECT_EQ(run(std::string(kOpenFoam) +
                  "cd openfoam && blockMesh && snappyHexMesh -overwrite && checkMesh"),
              0)
        << said();
    EXPECT_TRUE(has("Mesh OK")) << said();
    const std::string boundary = readFile(folder_ / "out/openfoam/constant/polyMesh/boundary");
    for (const char* patch : {"inlet", "outlet", "wall", "spheres"})
    {
        EXPECT_NE(boundary.find(fmt::format("    {}\n", patch)), std::string::npos) << boundary;
    }
}

/// A cube of edge 2, as three files beside a run that has filled it.
class VesselOfFiles : public BedFiles
{
protected:
    VesselOfFiles()
    {
        const TriangleMesh cube =
            boxMesh(Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)));
        for (const auto& [name, low, high] :
             {std::tuple("bottom", -4, -2), {"wall", -2, 2}, {"lid", 2, 4}})
        {
            TriangleMesh part{cube.vertices, {}};
            for (const auto& [a, b, c] : cube.triangles)
            {
                const double sum =
                    cube.vertices[a].y() + cube.vertices[b].y() + cube.vertices[c].y();
                if (sum > low && sum < high)
                {
                    part.triangles.push_back({a, b, c});
                }
            }
            writeStl(folder_ / (std::string(name) + ".stl"), part, name);
        }
        FillRequest request;
        const std::string files = (folder_ / "wall.stl").string() + "+" +
                                  (folder_ / "lid.stl").string() + "+" +
                                  (folder_ / "bottom.stl").string();
        request.scene = presetScene(Preset::fast, files);
        request.scene.spheres.count = 20;
        request.scene.spheres.radius = 0.28;
        request.scene.rest.mode = Rest::joint;
        request.scene.frames.enabled = false;
        request.scene.frames.keepRun = true;
        request.directory = folder_.path();
        request.overwrite = true;
        EXPECT_FALSE(frostfill::fill(request).failure);
    }
};

TEST_F(VesselOfFiles, HasTheirNamesInTextStl)
{
    write(ExportFormat::stlBed, "shrink:0.99", 4, true);
    std::vector<MeshPatch> patches;
    const TriangleMesh mesh = readMeshSandboxed(folder_ / "out/bed.stl", nullptr, &patches);
    std::string names;
    for (const MeshPatch& patch : patches)
    {
        names += fmt::format("{} {} ", patch.name, patch.triangles);
    }
    EXPECT_EQ(names,
              fmt::format("bottom 2 lid 2 wall 8 patch_spheres {} ", mesh.triangles.size() - 12));
}

TEST_F(VesselOfFiles, HasTheirNamesInOpenFoam)
{
    if (!isThere("which snappyHexMesh"))
    {
        GTEST_SKIP() << "snappyHexMesh is not installed";
    }
    write(ExportFormat::openFoam);
    EXPECT_EQ(run(std::string(kOpenFoam) + "cd openfoam && sed -i 's/endTime 200/endTime 3/' "
                                           "system/controlDict && ./Allrun"),
              0)
        << said();
    EXPECT_TRUE(has("Time = 3")) << said();
    const std::string boundary = readFile(folder_ / "out/openfoam/constant/polyMesh/boundary");
    for (const char* patch : {"bottom", "wall", "lid", "spheres"})
    {
        EXPECT_NE(boundary.find(fmt::format("    {}\n", patch)), std::string::npos) << boundary;
    }
}

TEST_F(VesselOfFiles, HasTheirNamesInLiggghts)
{
    if (!isThere("which liggghts"))
    {
        GTEST_SKIP() << "liggghts is not installed";
    }
    write(ExportFormat::liggghts);
    EXPECT_EQ(run("liggghts -in liggghts.in -log none"), 0) << said();
    const Packing after = readPacking(folder_ / "out/liggghts.dump");
    for (const Eigen::Vector3d& centre : after.centres)
    {
        EXPECT_LT(centre.cwiseAbs().maxCoeff(), 1 - 0.27);
    }
    EXPECT_EQ(after.centres.size(), 20U);
}

TEST_F(BedFiles, OfVoxelsHaveTheDistancesOfTheirSpheresAndAreReadByVtk)
{
    write(ExportFormat::vti);
    write(ExportFormat::npy);
    write(ExportFormat::csv);
    EXPECT_EQ(run("/usr/bin/python3 '" FROSTFILL_BED_READERS "/read_volume.py'"), 0) << said();
}

TEST_F(BedFiles, AreOfOneFrameWithASphere)
{
    ExportRequest request;
    request.run = folder_.path();
    request.format = ExportFormat::stlBed;
    request.out = folder_ / "out";
    request.frames = "0,last";
    expectError(
        ErrorCode::usage, [&] { exportRun(request); }, "one frame", "--frames");
    request.frames = "last";
    request.bed.resolution = 0;
    expectError(
        ErrorCode::usage, [&] { exportRun(request); }, "resolution");
    request.bed.resolution = 2;
    exportRun(request);
    expectError(
        ErrorCode::cannotCreate, [&] { exportRun(request); }, "bed.stl", "--overwrite");
    request.format = ExportFormat::gmsh;
    request.bed.contacts = ContactTreatment::caps;
    expectError(
        ErrorCode::usage, [&] { exportRun(request); }, "shrink");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out/bed.geo"));
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
// Packings as other programs publish them, and what is said where they cannot be read.
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/export.hpp>
#include <frostfill/fill.hpp>
#include <frostfill/packing.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace frostfill
{
namespace
{

using test::expectError;
using test::writeFile;

class OtherFormats : public ::testing::Test
{
protected:
    [[nodiscard]] Packing read(const std::string& content, const PackingFileOptions& options = {},
                               const char* name = "file") const
    {
        writeFile(folder_ / name, content);
        return readPacking(folder_ / name, options);
    }
    [[nodiscard]] Packing readBy(const std::string& columns, const std::string& content) const
    {
        return read(content, {.columns = parsePackingColumns(columns)});
    }
    static void expectTwo(const Packing& packing, const char* format)
    {
        ASSERT_EQ(packing.centres.size(), 2U) << packing.format;
        EXPECT_EQ(packing.centres[0], Eigen::Vector3d(0.5, -1, 2)) << packing.format;
        EXPECT_EQ(packing.centres[1], Eigen::Vector3d(1, 2, -3e-3)) << packing.format;
        EXPECT_EQ(packing.radii, (std::vector<double>{0.25, 0.5})) << packing.format;
        EXPECT_EQ(packing.atRest, (std::vector<bool>{true, true}));
        EXPECT_NE(packing.format.find(format), std::string::npos) << packing.format;
    }
    test::TemporaryFolder folder_;
};

TEST_F(OtherFormats, IncludeTheTextOfYadeInEachOfItsForms)
{
    expectTwo(read("#format x_y_z_r\n# a comment\n0.5\t-1\t2\t0.25\n1\t2\t-3e-3\t0.5\n"),
              "a table");
    expectTwo(read("#format id_x_y_z_r_matId\n7 0.5 -1 2 0.25 1\n8 1 2 -3e-3 0.5 1\n"), "a table");
    expectTwo(read("#format x_y_z_r_attrs\n# x y z r v\n0.5 -1 2 0.25 9\n1 2 -3e-3 0.5 9\n"),
              "a table");
}

TEST_F(OtherFormats, IncludeDataFilesOfLammpsInEachStyleOfSpheres)
{
    const std::string head = "LAMMPS data file via write_data\n\n2 atoms\n1 atom types\n\n"
                             "-9 9 xlo xhi\n-9 9 ylo yhi\n-9 9 zlo zhi\n\nMasses\n\n1 1\n\n";
    const std::string rows =
        "7 1 0.5 2500 0.5 -1 2 0 0 0\n3 1 1 2500 1 2 -3e-3 0 0 0 # a comment\n";
    const std::string rest = "\nVelocities\n\n7 0 0 0 0 0 0\n3 0 0 0 0 0 0\n";
    expectTwo(read(head + "Atoms # sphere\n\n" + rows + rest), "LAMMPS");
    expectTwo(read(head + "Atoms\n\n" + rows), "LAMMPS");
    expectTwo(read(head + "Atoms  # bpm/sphere\n\n1 1 1 0.5 9 0.5 -1 2\n2 1 1 1 9 1 2 -3e-3\n"),
              "LAMMPS");
    const Packing points =
        read(head + "Atoms # atomic\n\n1 1 0.5 -1 2\n2 1 1 2 3\n", {.radius = 0.25});
    EXPECT_EQ(points.radii, (std::vector<double>{0.25, 0.25}));
    EXPECT_EQ(points.centres[0], Eigen::Vector3d(0.5, -1, 2));
}

TEST_F(OtherFormats, IncludeTablesWhoseColumnsAreNamed)
{
    expectTwo(readBy("x=px,y=py,z=pz,radius=size", "pz,size,px,py\n2,0.25,0.5,-1\n-3e-3,0.5,1,2\n"),
              "table");
    expectTwo(readBy("x=px,y=py,z=pz,diameter=size",
                     "radius pz size px py\n9 2 0.5 0.5 -1\n9 -3e-3 1 1 2\n"),
              "table");
    expectTwo(readBy("x=1,y=2,z=3,radius=4", "0.5 -1 2 0.25\n1 2 -3e-3 0.5\n"), "table");
    expectTwo(readBy("x=4,y=3,z=2,diameter=1", "d;a;b;c\n0.5;2;-1;0.5\n1;-3e-3;2;1\n"), "table");
    expectTwo(readBy("z=h", "h,x,z,y,r\n2,0.5,7,-1,0.25\n-3e-3,1,7,2,0.5\n"), "table");
    expectTwo(
        read("\"Points:0\",\"Points:1\",\"Points:2\",\"Diameter\"\n0.5,-1,2,0.5\n1,2,-3e-3,1\n"),
        "table"); // of ParaView
    const Packing one =
        read("a b c\n1 2 3\n", {.radius = 0.125, .columns = {.x = "a", .y = "b", .z = "c"}});
    EXPECT_EQ(one.radii, (std::vector<double>{0.125}));
}

TEST_F(OtherFormats, GiveBackWhatWasExportedToTheLastBit)
{
    FillRequest request;
    request.scene = presetScene(Preset::fast, "cube");
    request.scene.spheres.radius = Radii(0.1, 0.3);
    request.scene.spheres.count = 40;
    request.scene.frames.enabled = false;
    request.scene.frames.keepRun = true;
    request.directory = folder_ / "run";
    ASSERT_FALSE(fill(request).failure);
    const Packing run = readPacking(folder_ / "run");
    ASSERT_EQ(run.centres.size(), 40U);
    struct Exported
    {
        const char* format;
        const char* file;
    };
    for (const Exported& each : {Exported{"yade", "yade.txt"},
                                 {"lethe", "particles.input"},
                                 {"lammps", "lammps.data"},
                                 {"liggghts", "liggghts.data"},
                                 {"csv", ""},
                                 {"xyz", "spheres.xyz"},
                                 {"lammps-dump", "spheres.dump"}})
    {
        const ExportResult result = exportRun({.run = folder_ / "run",
                                               .format = exportFormat(each.format).format,
                                               .frames = "last",
                                               .out = folder_ / "out"});
        const Packing again =
            readPacking(*each.file == '\0' ? result.files.front() : folder_ / "out" / each.file);
        EXPECT_EQ(again.centres, run.centres) << each.format;
        EXPECT_EQ(again.radii, run.radii) << each.format;
    }
}

// It writes them in an order of its own, with 17 digits.
TEST_F(OtherFormats, IncludeWhatLammpsItselfWrites)
{
    if (std::system("which lmp >/dev/null 2>&1") != 0) // NOLINT(cert-env33-c): of our own words
    {
        GTEST_SKIP() << "lmp is not installed";
    }
    writeFile(folder_ / "in.lammps",
              "units si\natom_style sphere\nboundary f f f\nregion box block -1 1 -1 1 -1 1\n"
              "create_box 1 box\ncreate_atoms 1 random 50 7 box\n"
              "variable size atom 0.01+0.001*id\nset type 1 density 2500\n"
              "set type 1 diameter v_size\npair_style none\ncomm_modify cutoff 1\n"
              "write_data written.data\nwrite_dump all custom written.dump x y z radius "
              "modify format float %.17g\n");
    const std::string command =
        "cd '" + folder_.path().string() + "' && lmp -in in.lammps -log none >said.txt 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) // NOLINT(cert-env33-c): of our own words
        << test::readFile(folder_ / "said.txt");
    const Packing data = readPacking(folder_ / "written.data");
    const Packing dump = readPacking(folder_ / "written.dump");
    EXPECT_NE(data.format.find("data file of LAMMPS"), std::string::npos) << data.format;
    const auto sorted = [](const Packing& packing)
    {
        std::vector<std::array<double, 4>> rows;
        for (std::size_t k = 0; k < packing.centres.size(); ++k)
        {
            const Eigen::Vector3d& p = packing.centres[k];
            rows.push_back({packing.radii[k], p.x(), p.y(), p.z()});
        }
        std::sort(rows.begin(), rows.end());
        return rows;
    };
    EXPECT_EQ(data.centres.size(), 50U);
    EXPECT_EQ(sorted(data), sorted(dump));
}

struct Wrong
{
    const char* columns; ///< empty: none
    std::string content;
    const char* where;
    const char* what;
};

TEST_F(OtherFormats, AreRefusedWithTheLineOfTheirFault)
{
    const std::vector<Wrong> cases = {
        {"", "#format x_y_r\n1 2 3\n", "line 1", "no column z"},
        {"", "#format x_y_z\n1 2 3\n", "line 1", "--radius"},
        {"", "#format \n1 2 3 4\n", "line 1", "no column x"},
        {"", "#format x_y_z_r\n1 2 3 4\n1 2 3\n", "line 3", "3 values, where 4 are needed"},
        {"", "#format x_y_z_r\n1 2 3 nan\n", "line 2",
         "the radius of sphere 1 is nan, not above 0"},
        {"", "#format x_y_z_r\n1 2 3 -4\n", "line 2", "the radius of sphere 1 is -4, not above 0"},
        {"", "#format x_y_z_r\n1 two 3 4\n", "line 2", "'two' is no number"},
        {"x=1,y=2,z=3,radius=7", "1 0 0 0 0 1 1 1\n1 2 3 0 0 0 0.5 0 0\n", "line 2",
         "9 values, where the first line has 8"},
        {"", "0.1 0.2 0.3 0.4\n1 2 3 4\n", "line 1", "--columns x=1,y=2,z=3,radius=4"},
        {"x=a,y=b,z=d", "a,b,c,r\n1,2,3,4\n", "line 1", "no column 'd' among a, b, c, r"},
        {"x=5", "a,b,c,r\n1,2,3,4\n", "line 1", "no column 5: there are 4"},
        {"x=0", "a,y,z,r\n1,2,3,4\n", "line 1", "no column 0"},
        {"x=a", "1,2,3,4\n1,2,3,4\n", "line 1", "no heading"},
        {"x=a,y=b", "a,b,c,r\n1,2,3,4\n", "line 1", "no column z"},
        {"x=a,y=b,z=c", "a,b,c\n1,2,3\n", "line 1", "--radius"},
        {"x=a,y=b,z=c,diameter=d", "a,b,c,d\n1,2,3,-4\n", "line 2",
         "the diameter of sphere 1 is -4, not above 0"},
        {"x=a,y=b,z=c,radius=d", "a,b,c,d\n1,2,3,4\n1,2,3,\n", "line 3",
         "3 values, where 4 are needed"},
        {"x=a,y=b,z=c,radius=d", "a;b;c;d\n1;2;3;four\n", "line 2", "'four' is no number"},
    };
    for (const Wrong& each : cases)
    {
        expectError(
            ErrorCode::badData,
            [&]
            {
                writeFile(folder_ / "file", each.content);
                PackingFileOptions options;
                options.columns =
                    *each.columns == '\0' ? PackingColumns{} : parsePackingColumns(each.columns);
                (void)readPacking(folder_ / "file", options);
            },
            std::string("file, ") + each.where + ":", each.what);
    }
    expectError(
        ErrorCode::badData, [&] { (void)read(std::string("1 2 3\0", 6)); }, "is not a text");
}

TEST_F(OtherFormats, RefuseColumnsThatCannotBeMeant)
{
    const auto refuse = [](const char* text, const std::string& says)
    {
        expectError(
            ErrorCode::usage, [&] { (void)parsePackingColumns(text); }, says);
    };
    refuse("", "names no column");
    refuse("x", "'x' names no column");
    refuse("x=", "'x=' names no column");
    refuse("x=a,", "'' names no column");
    refuse("radios=a", "did you mean radius?");
    refuse("mass=a", "x, y, z, radius or diameter");
    refuse("x=a,x=b", "x is given twice");
    refuse("radius=a,diameter=b", "leave out one");
    const std::string dump = "ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y z radius\n1 2 3 4\n";
    expectError(
        ErrorCode::usage, [&] { (void)readBy("x=a", dump); }, "file", "is a LAMMPS dump");
}

} // namespace
} // namespace frostfill

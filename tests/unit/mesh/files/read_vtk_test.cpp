// SPDX-License-Identifier: MIT
// The samples are boxes that VTK 9.1 has written.
#include "mesh/files/readers.hpp"
#include "unit/mesh/files/mesh_texts.hpp"
#include "unit/mesh/files/samples.hpp"

#define ZLIB_CONST
#include <zlib.h>

namespace frostfill
{
namespace
{

std::string gzipped(const std::string& bytes)
{
    constexpr int kGzip = 16 + 15;
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, kGzip, 8, Z_DEFAULT_STRATEGY), Z_OK);
    std::string packed(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<const Bytef*>(bytes.data());
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

TEST(ReadVtk, ReadsWhatVtkWrites)
{
    for (const std::string& name : test::vtkSamples())
    {
        SCOPED_TRACE(name);
        const LoadedMesh box =
            repairMesh(test::parse(test::sample(name), "unknown"), name); // by its content
        EXPECT_TRUE(box.repairs.empty());
        EXPECT_EQ(box.report.vertices, 8U);
        EXPECT_EQ(box.report.triangles, 12U);
        EXPECT_EQ(box.report.volume, 1.0);
    }
}

TEST(ReadVtk, JoinsThePiecesOfAFile)
{
    const std::string piece =
        R"(<Piece NumberOfPoints="3"><Points><DataArray type="Float32" format="ascii">)"
        R"(0 0 0 1 0 0 0 1 0</DataArray></Points><!-- > --><Polys>)"
        R"(<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>)"
        R"(<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece>)";
    const std::string end = "</PolyData></VTKFile>";
    const std::string two = R"(<VTKFile type="PolyData"><PolyData>)" + piece +
                            test::replaced(piece, "0 0 0 1 0 0 0 1 0", "0 0 1 1 0 1 0 1 1") + end;
    EXPECT_EQ(test::parse(two, "two.vtp").vertices.size(), 6U);
    test::expectUnreadable(test::replaced(two, "0 1 2<", "0 1 3<"), "two.vtp",
                           "cell 0: it names point 3 of 3");
    test::expectUnreadable(test::replaced(two, ">3<", ">4<"), "two.vtp", "cell 0: its corners");
    test::expectUnreadable(test::replaced(two, "0 0 0 1", "0 0 zero 1"), "two.vtp",
                           "its 3. number is 'zero 1");
    test::expectUnreadable(test::replaced(two, "Points=\"3", "Points=\"4"), "two.vtp",
                           "it promises 4 points and holds 3");
}

TEST(ReadVtk, NamesWhatItCannotRead)
{
    const std::string grid = test::sample("grid.vtk");
    test::expectUnreadable(test::replaced(grid, "UNSTRUCTURED_GRID", "STRUCTURED_POINTS"), "a.vtk",
                           "a 'STRUCTURED_POINTS' of VTK");
    const std::string appended = test::sample("appended.vtp");
    test::expectUnreadable(test::replaced(appended, "ZLib", "LZ4"), "a.vtp",
                           "compressed by 'vtkLZ4DataCompressor'");
    test::expectUnreadable(test::replaced(appended, "\"PolyData\"", "\"ImageData\""), "a.vtp",
                           "a 'ImageData' of VTK");
    const std::string tetrahedron =
        "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
        "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";
    test::expectUnreadable(tetrahedron, "a.vtk", "cell 0: it is of VTK's type 10");
    test::expectUnreadable(test::replaced(tetrahedron, "POINTS 4", "POINTS 4000"), "a.vtk",
                           "'4000' is no count that this file has room for");
}

TEST(Gunzip, ReadsEveryFormatAsItIsUnpacked)
{
    const TriangleMesh box = test::box(0, 1);
    for (const auto& [name, bytes] : {std::pair{"box.obj.gz", test::objText(box)},
                                      {"box.stl.gz", test::binaryStl(box)},
                                      {"box.off.gz", test::exactOff(box)},
                                      {"box.vtp.gz", test::sample("appended.vtp")}})
    {
        EXPECT_EQ(test::parse(gzipped(bytes), name).triangles.size(), 12U) << name;
    }
    const std::string obj = test::objText(box);
    const std::string members = gzipped(obj.substr(0, 50)) + gzipped(obj.substr(50));
    EXPECT_EQ(test::parse(members, "box.obj.gz").triangles.size(), 12U);
}

TEST(Gunzip, RefusesDamageAndBombs)
{
    const std::string packed = gzipped(test::objText(test::box(0, 1)));
    test::expectUnreadable(packed.substr(0, packed.size() - 9), "box.obj.gz", "cut off or damaged");
    test::expectUnreadable(gzipped(packed), "box.obj.gz.gz", "compressed (gzip) twice");
    test::expectUnreadable(gzipped(std::string(10'000'000, ' ')), "box.obj.gz",
                           "more than 256 times its size");
}

TEST(Gunzip, TellsTheSizeOfTheContentWithinReason)
{
    const std::string text(3000, 'v');
    EXPECT_EQ(contentSize(test::writtenMesh("plain.obj", text)), 3000U);
    const std::string packed = gzipped(text);
    ASSERT_LT(16 * packed.size(), text.size());
    EXPECT_EQ(contentSize(test::writtenMesh("packed.obj.gz", packed)), 16 * packed.size());
    EXPECT_EQ(contentSize(test::outputFile("no.obj.gz")), 0U);
}

TEST(MeshFiles, OfAFolderOrOfSeveralNamesArePatchesOfOneMesh)
{
    TriangleMesh lid = test::box(0, 1);
    TriangleMesh wall = lid;
    lid.triangles.resize(2);
    wall.triangles.erase(wall.triangles.begin(), wall.triangles.begin() + 2);
    const auto folder = test::outputFile("vessel");
    std::filesystem::create_directories(folder);
    const auto lidFile = test::writtenMesh("vessel/lid+top.obj", test::objText(lid));
    const auto wallFile = test::writtenMesh("vessel/wall.stl.gz", gzipped(test::binaryStl(wall)));
    test::writtenMesh("vessel/notes.txt", "no mesh");
    const std::filesystem::path names = wallFile.string() + "+" + wallFile.string();
    EXPECT_EQ(readMesh(names).triangles.size(), 20U);
    EXPECT_EQ(readMesh(lidFile).triangles.size(), 2U); // the name of a file, even with a plus
    const LoadedMesh vessel = loadMesh(folder.string());
    EXPECT_TRUE(vessel.repairs.empty());
    EXPECT_EQ(vessel.report.vertices, 8U);
    EXPECT_EQ(vessel.report.volume, 1.0);
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    test::expectRefused(ErrorCode::inputMissing, "has no mesh",
                        [&] { (void)loadMesh(folder.string()); });
}

} // namespace
} // namespace frostfill

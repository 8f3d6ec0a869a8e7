// SPDX-License-Identifier: MIT
#include "unit/mesh/files/mesh_texts.hpp"

namespace frostfill
{
namespace
{

using test::expectSquare;
using test::expectUnreadable;
using test::parse;
using test::Triangles;

/// The square, with words behind each vertex and each face.
std::string square(const std::string& head, const std::string& vertex = "",
                   const std::string& face = "")
{
    const std::string end = vertex + "\n";
    return head + "\n0 0 0" + end + "1 0 0" + end + "1 1 0" + end + "0 1 0" + end + "4 0 1 2 3" +
           face + "\n";
}

TEST(ReadOff, TakesItsHeadInAllItsForms)
{
    for (const char* head :
         {"OFF\n4 1 0", "OFF 4 1 0", "OFF\n4 1 4", "OFF\n4 1", "OFF\n4 1\n0", "4 1 0",
          "OFF\n4\n1\n0", "# before\nOFF # here\n\n# a comment\n4 1 0 # counts\n\n# vertices",
          "OFF\r\n4 1 0\r"})
    {
        expectSquare("square.off", square(head));
    }
    expectSquare("square.off", test::replaced(square("OFF\n4 1 0"), "\n", "\r"));
    expectSquare("square.off", "\xef\xbb\xbf" + square("OFF\n4 1 0"));
    expectSquare("square.off", test::utf16(square("OFF\n4 1 0"), true));
}

TEST(ReadOff, TakesItsRelativesAndTheirColours)
{
    expectSquare("square.off", square("COFF\n4 1 0", " 255 0 0 255"));
    expectSquare("square.off", square("COFF\n4 1 0", " 0.1 0.2 0.3"));
    expectSquare("square.off", square("NOFF\n4 1 0", " 0 0 1"));
    expectSquare("square.off", square("STOFF\n4 1 0", " 0.5 0.5"));
    expectSquare("square.off", square("CNOFF\n4 1 0", " 0 0 1 1 0 0 1"));
    expectSquare("square.off", square("STCNOFF\n4 1 0", " 0 0 1 1 0 0 1 0 0"));
    expectSquare("square.off", square("OFF\n4 1 0", "", " 3 0.5 0.5 0.5"));
    expectSquare("square.off", square("OFF\n4 1 0", " # a vertex", " # a face"));
}

TEST(ReadOff, TakesFacesThatAreBrokenOverLines)
{
    const std::string vertices = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    expectSquare("square.off", vertices + "3 0 1\n2\n3 0\n2 3\n");
    expectSquare("square.off", vertices + "3\n0\n1 # a comment\n\n2 255 0 0\n3 0 2 3\n");
    expectUnreadable(vertices + "3 0 1\n3 0 2 3\n", "a.off", "the file ends after 1 of 2 faces");
    expectUnreadable(vertices + "3 0 1 2\n3 0\n\n2\n", "a.off",
                     "line 8: the face has too few numbers");
}

TEST(ReadOff, RefusesByNameWhatItCannotRead)
{
    expectUnreadable("OFF BINARY\n" + std::string(40, '\0'), "a.off", "line 1: binary OFF");
    expectUnreadable("OFF\nBINARY\n4 1 0\n", "a.off", "binary OFF");
    expectUnreadable("4OFF\n4 1 0\n", "a.off", "more than three dimensions");
    expectUnreadable("nOFF\n3\n4 1 0\n", "a.off", "more than three dimensions");
}

TEST(ReadOff, KeepsEveryBitOfEveryNumber)
{
    TriangleMesh mesh = builtInMesh("torus");
    mesh.vertices[0] = {1e6 + 1.0 / 3, 0.1, 5e-324};
    const TriangleMesh read = parse(test::exactOff(mesh), "torus.off");
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.triangles, mesh.triangles);
}

TEST(ReadOff, BelievesNoCount)
{
    expectUnreadable("OFF\n4000000000 4000000000 0\n", "a.off",
                     "line 2: 4000000000 vertices are promised");
    expectUnreadable("OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n", "a.off",
                     "line 2: 4000000000 faces are promised");
    expectUnreadable("OFF\n-1 1 0\n", "a.off", "line 2: -1 is no count");
    expectUnreadable("OFF\n" + std::string(500, '9') + " 1 0\n", "a.off", "line 2: '9999");
    expectUnreadable(square("OFF\n4 1 0") + "3 0 1 2\n", "a.off",
                     "line 8: the file has more data after its 1 faces");
    expectUnreadable(square("OFF\n4 2 0"), "a.off", "the file ends after 1 of 2 faces");
    expectUnreadable("OFF\n4 1 0\n0 0 0 1 1 1 1 1 1\n1 0 0\n", "a.off",
                     "the file ends after 2 of 4 vertices");
    expectUnreadable("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n", "a.off",
                     "line 6: the face has too few numbers");
    expectUnreadable("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "a.off", "line 6: -3");
}

TEST(ReadOff, RefusesIndicesAndNumbersWithTheirLine)
{
    expectUnreadable("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off",
                     "line 6: the face names vertex 3, but the file has 3 (numbered from 0)");
    expectUnreadable("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.off", "vertex -1");
    expectUnreadable("OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "a.off", "line 4");
    expectUnreadable("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "a.off",
                     "line 4: the vertex has too few numbers");
    expectUnreadable("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "a.off", "a point cloud");
}

} // namespace
} // namespace frostfill

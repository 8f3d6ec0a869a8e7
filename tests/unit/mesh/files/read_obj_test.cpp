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

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, TakesFacesInAllTheirForms)
{
    for (const char* face :
         {"f 1 2 3 4\n", "f 1 2 3\nf 1 3 4\n", "f -4 -3 -2 -1\n", "f 1/1 2/1 3/1 4/1\n",
          "f 1//1 2//1 3//1 4//1\n", "f 1/1/1 2/1/1 3/1/1 4/1/1\n", "f -4/-1/-1 -3/9 -2// -1/\n",
          "f 1 2 3 4", "f\t1 \t2\t3   4 \t\n", "f 1 2 \\\n 3 4\n", "f \\\r\n1 2 3\\\r\n4\n",
          "f 1 2 3 4 # one\n", "fo 1 2 3 4\n", "  f 1 2 3 4\n"})
    {
        expectSquare("square.obj", kSquare + face);
    }
}

TEST(ReadObj, SkipsAllThatIsNoSurface)
{
    expectSquare("square.obj",
                 "# made by hand \\\nmtllib C:\\absent\\\no thing\n\n" + kSquare +
                     "vt 0.5 0.5\nvn 0 0 1\nvp 1\ng a b\nusemtl none\ns off\np 1 2\nl 1 2 3\n"
                     "cstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\nf 1 2 3 4\n");
    expectSquare("square.obj",
                 "v 0 0 0 1\nv 1 0 0 0.5\nv 1 1 0 1 0 0\nv 0 1 0 0.1 0.2 0.3\nf 1 2 3 4\n");
}

TEST(ReadObj, TakesFacesBeforeTheirVertices)
{
    expectSquare("square.obj", "f 1 2 3 4\n" + kSquare);
}

TEST(ReadObj, TakesEveryEncodingAndEndOfLine)
{
    const std::string text = "# \xc3\xa4\n" + kSquare + "f 1 2 3 4\n";
    expectSquare("square.obj", "\xef\xbb\xbf" + text);
    expectSquare("square.obj", test::utf16(text, false));
    expectSquare("square.obj", test::utf16(text, true));
    expectSquare("square.obj", test::replaced(text, "\n", "\r\n"));
    expectSquare("square.obj", test::replaced(text, "\n", "\r"));
    expectSquare("square.obj", test::utf16(test::replaced(text, "\n", "\r\n"), true));
}

TEST(ReadObj, TakesNumbersAsCWritesThem)
{
    const TriangleMesh mesh =
        parse("v +1 -.5 1e-3\nv 1.E+2 00 -0\nv 7e0 2. 3\nf +1 2 3\n", "a.obj");
    EXPECT_EQ(mesh.vertices,
              (std::vector<Eigen::Vector3d>{{1, -0.5, 0.001}, {100, 0, 0}, {7, 2, 3}}));
}

TEST(ReadObj, KeepsEveryBitOfEveryNumber)
{
    TriangleMesh mesh = builtInMesh("human");
    mesh.vertices[0] = {1e6 + 1.0 / 3, 0.1, 5e-324};
    mesh.vertices[1] = {-1e-300, 123456789.123456789, -1e60};
    const TriangleMesh read = parse(test::exactObj(mesh), "human.obj");
    EXPECT_EQ(read.vertices, mesh.vertices);
    EXPECT_EQ(read.triangles, mesh.triangles);
}

TEST(ReadObj, RefusesIndicesThatNameNothingWithLineAndNumber)
{
    expectUnreadable(kSquare + "f 1 2 5\n", "a.obj",
                     "line 5: the face names vertex 5, but the "
                     "file has 4 (numbered from 1)");
    expectUnreadable(kSquare + "\nf 1 2 -5\n", "a.obj", "line 6: the face names vertex -5");
    expectUnreadable(kSquare + "f 0 1 2\n", "a.obj", "line 5: the face names vertex 0");
    expectUnreadable(kSquare + "f 1 2 3 4 4000000000\n", "a.obj", "vertex 4000000000");
    expectUnreadable(kSquare + "f 1 2 99999999999999\n", "a.obj", "vertex 99999999999999");
    expectUnreadable(kSquare + "f 1 2 99999999999999999999\n", "a.obj", "line 5: '9999");
    expectUnreadable(kSquare + "f 1 2 1.5\n", "a.obj", "line 5: '1.5' is not a whole number");
    expectUnreadable(kSquare + "f 1 2 /3\n", "a.obj", "line 5:");
}

TEST(ReadObj, RefusesWhatIsNoNumberWithItsLine)
{
    for (const char* word : {"1,5", "0x1p3", "1.#IND", "--1", "+-1", "+", "-", "e5", "1e", "1_000"})
    {
        expectUnreadable("v 0 0 0\nv 0 0 " + std::string(word) + "\n", "a.obj",
                         "line 2: '" + std::string(word) + "' is not a number");
    }
    for (const char* word : {"nan", "NaN", "inf", "-inf", "Infinity", "-nan"})
    {
        expectUnreadable("v 0 0 0\n\n\nv 0 " + std::string(word) + " 0\n", "a.obj",
                         "line 4: the vertex has a coordinate that is infinite or not a number");
    }
    expectUnreadable("v 0 0\n", "a.obj", "line 1: the vertex has too few numbers");
    expectUnreadable("v 0 1e999 0\n", "a.obj", "line 1: the number '1e999' is too large");
    expectUnreadable("v " + std::string(100'000, '1') + " 0 0\n", "a.obj", "...' is too large");
}

TEST(ReadObj, TakesNumbersBelowTheSmallestAsZero)
{
    const TriangleMesh mesh = parse(
        "v 1e-999 -1e-400 0." + std::string(400, '0') + "1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
    EXPECT_EQ(mesh.vertices[0], Eigen::Vector3d::Zero());
}

TEST(ReadObj, SaysWhenThereAreOnlyPointsOrLines)
{
    expectUnreadable(kSquare, "a.obj", "4 vertices but no faces, a point cloud");
    expectUnreadable(kSquare + "p 1 2\nl 1 2 3\nf 1 2\n", "a.obj", "only points and lines");
    expectUnreadable("o nothing\n", "a.obj", "neither vertices nor faces");
}

TEST(ReadObj, LeavesOutCornersThatFollowThemselves)
{
    const TriangleMesh mesh = parse(kSquare + "f 1 2 2 3 4 1\n", "a.obj");
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

} // namespace
} // namespace frostfill

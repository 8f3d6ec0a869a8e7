// SPDX-License-Identifier: MIT
#include "unit/mesh/files/mesh_texts.hpp"

#include <cctype>
#include <limits>

namespace frostfill
{
namespace
{

using test::expectUnreadable;
using test::parse;

std::string upper(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

TEST(ReadStl, TellsTextFromBytesByMoreThanTheFirstWord)
{
    const TriangleMesh box = test::box(0, 1);
    for (const std::string& bytes :
         {test::asciiStl(box), test::binaryStl(box), test::binaryStl(box, "solid of a liar"),
          test::binaryStl(box, "solid of a liar") + "padding", test::binaryStl(box) + "\n",
          test::binaryStl(box, "\xff\xfe looks like a mark"), upper(test::asciiStl(box)),
          test::replaced(test::asciiStl(box), "\n", "\r\n"),
          test::replaced(test::asciiStl(box), "\n", "\r"), "\n\n  " + test::asciiStl(box),
          test::utf16(test::asciiStl(box), false), "\xef\xbb\xbf" + test::asciiStl(box)})
    {
        const TriangleMesh mesh = parse(bytes, "box.stl");
        EXPECT_EQ(mesh.triangles.size(), 12U);
        EXPECT_EQ(mesh.vertices.size(), 8U);
        EXPECT_EQ(signedVolume(mesh), 1.0);
    }
}

TEST(ReadStl, KeepsEveryBitOfText)
{
    TriangleMesh mesh = test::soup(builtInMesh("sphere"));
    mesh.vertices[0] = {1e6 + 1.0 / 3, 0.1, 5e-324};
    const TriangleMesh read = parse(test::asciiStl(mesh), "sphere.stl");
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
        for (std::size_t corner = 0; corner < 3; ++corner)
        {
            EXPECT_EQ(read.vertices[read.triangles[i][corner]],
                      mesh.vertices[mesh.triangles[i][corner]]);
        }
    }
}

TEST(ReadStl, TakesSeveralSolidsAndNamesOfManyWords)
{
    const std::string one = test::asciiStl(test::box(0, 1));
    const std::string two =
        test::replaced(test::asciiStl(test::box(2, 3)), "by hand", "facet vertex endsolid 3");
    EXPECT_EQ(parse(one + two, "two.stl").triangles.size(), 24U);
    EXPECT_EQ(parse(test::replaced(one, " by hand", ""), "a.stl").triangles.size(), 12U);
}

TEST(ReadStl, RefusesTextThatIsCutOff)
{
    const std::string text = test::asciiStl(test::box(0, 1));
    expectUnreadable(text.substr(0, text.size() - 20), "a.stl", "before its 'endsolid'");
    expectUnreadable(text.substr(0, text.find("vertex 0 1 0")), "a.stl", "line 5");
    expectUnreadable("solid\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendsolid\n", "a.stl",
                     "line 4: a facet has 2 of 3 vertices");
    expectUnreadable("solid\nendsolid\n", "a.stl", "neither vertices nor faces");
    expectUnreadable("solid\nvertex 0 0 inf\nendsolid\n", "a.stl", "line 2");
    expectUnreadable(text + "and more\n", "a.stl", "'and' stands where 'solid' should");
}

TEST(ReadStl, BelievesNoCountOfABinaryFile)
{
    std::string bytes = test::binaryStl(test::box(0, 1));
    expectUnreadable(bytes.substr(0, bytes.size() - 1), "a.stl", "byte 80: 12 triangles");
    expectUnreadable(bytes.substr(0, 83), "a.stl", "it is no STL");
    bytes[80] = bytes[81] = bytes[82] = bytes[83] = '\xff';
    expectUnreadable(bytes, "a.stl", "byte 80: 4294967295 triangles");
    expectUnreadable(std::string(84, '\0'), "a.stl", "neither vertices nor faces");
}

TEST(ReadStl, RefusesNumbersThatAreNotFiniteWithTheirByte)
{
    TriangleMesh mesh = test::box(0, 1);
    mesh.vertices[0].y() = std::numeric_limits<double>::infinity();
    expectUnreadable(test::binaryStl(mesh), "a.stl", "byte 100: a coordinate is infinite");
}

} // namespace
} // namespace frostfill

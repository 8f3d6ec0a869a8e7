// SPDX-License-Identifier: MIT
#include "unit/mesh/files/mesh_texts.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace frostfill
{
namespace
{

using test::appendBytes;
using test::expectSquare;
using test::expectUnreadable;
using test::parse;
using test::Triangles;

const std::string kHead = "ply\nformat ascii 1.0\n";
const std::string kVertices = "element vertex 4\nproperty float x\nproperty float y\n"
                              "property float z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kCornersText = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(ReadPly, TakesTextInAllItsForms)
{
    const std::string plain =
        kHead + "comment hello\nobj_info there\n" + kVertices + kFaces + "end_header\n";
    expectSquare("square.ply", plain + kCornersText + "4 0 1 2 3\n");
    expectSquare("square.ply", plain + kCornersText + "4 0 1 2 3");
    expectSquare("square.ply", plain + "\n" + kCornersText + "\n4 0 1 2 3\n\n");
    expectSquare("square.ply", test::replaced(plain + kCornersText + "4 0 1 2 3\n", "\n", "\r\n"));
    expectSquare("square.ply", test::replaced(plain + kCornersText + "4 0 1 2 3\n", "\n", "\r"));
    expectSquare("square.ply", "\xef\xbb\xbf" + plain + kCornersText + "4 0 1 2 3\n");
    expectSquare("square.ply", test::utf16(plain + kCornersText + "4 0 1 2 3\n", false));
    expectSquare("square.ply", test::replaced(plain, "vertex_indices", "vertex_index") +
                                   kCornersText + "4 0 1 2 3\n");
}

// As exporters write them that put colours into lines without naming them in the header.
TEST(ReadPly, OverlooksValuesBeyondThoseOfTheHeaderAndSaysSo)
{
    const std::string square = kHead + kVertices + kFaces + "end_header\n" + kCornersText;
    const std::string first =
        test::replaced(square, "1 1 0\n", "1 1 0 255 0 0\n") + "4 0 1 2 3 0.5\n";
    expectSquare("square.ply", first);
    const std::filesystem::path file = test::writtenMesh("longer.ply", first);
    std::vector<std::string> remarks;
    (void)readMesh(file, &remarks);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_EQ(remarks[0],
              "ignored what 2 lines have more than the header says, the first in line 12");
    (void)readMeshSandboxed(file, &remarks);
    ASSERT_EQ(remarks.size(), 2U);
    EXPECT_EQ(remarks[1], remarks[0]);
    (void)readMeshSandboxed(test::writtenMesh("square.ply", square + "4 0 1 2 3\n"), &remarks);
    EXPECT_EQ(remarks.size(), 2U);
}

TEST(ReadPly, TakesPropertiesInAnyOrderAndSkipsTheRest)
{
    const std::string vertices = "element vertex 4\nproperty uchar red\nproperty double z\n"
                                 "property list uchar float weights\nproperty float y\n"
                                 "property float nx\nproperty int x\n";
    const std::string points = "255 0 2 1 nan 0 1 0\n0 0 0 0 1 1\n0 0 0 1 1 1\n9 0 1 5 1 1 0\n";
    const std::string faces = "element face 1\nproperty uchar flags\n"
                              "property list uchar int vertex_indices\n"
                              "property list int float texcoord\n";
    expectSquare("square.ply",
                 kHead + vertices + faces + "end_header\n" + points + "7 4 0 1 2 3 1 0.5\n");
}

TEST(ReadPly, SkipsElementsThatItDoesNotKnow)
{
    expectSquare(
        "square.ply",
        kHead + "element camera 2\nproperty float view\nproperty list uchar int ids\n" + kVertices +
            "element edge 1\nproperty int a\nproperty int b\n" + kFaces +
            "element void 4000000000\nelement material 1\nproperty float shine\nend_header\n"
            "0.5 2 7 8\n1 0\n" +
            kCornersText + "0 1\n4 0 1 2 3\n0.5\n");
    expectSquare("square.ply",
                 kHead + kFaces + kVertices + "end_header\n4 0 1 2 3\n" + kCornersText);
}

/// The square with coordinates, count and indices of these types.
template <typename Coordinate, typename Count, typename Index>
std::string binarySquare(const std::string& coordinate, const std::string& count,
                         const std::string& index, bool bigEndian)
{
    std::string bytes = std::string("ply\r\nformat binary_") + (bigEndian ? "big" : "little") +
                        "_endian 1.0\r\nelement vertex 4\r\n";
    for (const char* axis : {"x", "y", "z"})
    {
        bytes += "property " + coordinate + " " + axis + "\r\n";
    }
    bytes += "element face 1\r\nproperty list " + count + " " + index + " vertex_indices\r\n" +
             "element tail 2\r\nproperty list " + count + " " + index + " list\r\nend_header\r\n";
    for (const int value : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})
    {
        appendBytes(bytes, static_cast<Coordinate>(value), bigEndian);
    }
    appendBytes(bytes, Count{4}, bigEndian);
    for (int corner = 0; corner < 4; ++corner)
    {
        appendBytes(bytes, static_cast<Index>(corner), bigEndian);
    }
    appendBytes(bytes, Count{0}, bigEndian);
    appendBytes(bytes, Count{1}, bigEndian);
    appendBytes(bytes, Index{0}, bigEndian);
    return bytes;
}

TEST(ReadPly, TakesEveryTypeInBothByteOrders)
{
    for (const bool big : {false, true})
    {
        expectSquare("square.ply",
                     binarySquare<float, std::uint8_t, std::int32_t>("float", "uchar", "int", big));
        expectSquare("square.ply", binarySquare<double, std::int8_t, std::uint32_t>(
                                       "float64", "char", "uint32", big));
        expectSquare("square.ply", binarySquare<std::int16_t, std::uint16_t, std::int16_t>(
                                       "short", "ushort", "int16", big));
        expectSquare("square.ply", binarySquare<std::uint8_t, std::int16_t, std::uint8_t>(
                                       "uint8", "int16", "uchar", big));
        expectSquare("square.ply", binarySquare<std::int8_t, std::int32_t, std::uint16_t>(
                                       "int8", "int32", "uint16", big));
        expectSquare("square.ply", binarySquare<std::uint32_t, std::uint32_t, std::int8_t>(
                                       "uint", "uint32", "char", big));
        expectSquare("square.ply", binarySquare<std::int64_t, std::uint64_t, float>(
                                       "int64", "uint64", "float32", big));
        expectSquare("square.ply", binarySquare<std::uint16_t, std::int64_t, double>(
                                       "uint16", "long", "double", big));
    }
}

TEST(ReadPly, KnowsWhereTheDataBeginWhateverEndsTheLines)
{
    // The first byte of the data is a line feed.
    std::string tail;
    for (const int value : {10, 0, 0, 1, 0, 0, 1, 1, 0})
    {
        appendBytes(tail, static_cast<std::int8_t>(value));
    }
    appendBytes(tail, std::uint8_t{3});
    for (const int corner : {0, 1, 2})
    {
        appendBytes(tail, static_cast<std::int8_t>(corner));
    }
    for (const char* end : {"\n", "\r\n", "\r"})
    {
        const std::string head =
            "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\n"
            "property char y\nproperty char z\nelement face 1\nproperty list uchar char "
            "vertex_indices\nend_header\n";
        const TriangleMesh mesh = parse(test::replaced(head, "\n", end) + tail, "a.ply");
        EXPECT_EQ(mesh.vertices[0].x(), 10);
    }
}

/// Two zeros of different signs differ in them.
std::array<std::uint64_t, 3> bitsOf(const Eigen::Vector3d& point)
{
    return {std::bit_cast<std::uint64_t>(point.x()), std::bit_cast<std::uint64_t>(point.y()),
            std::bit_cast<std::uint64_t>(point.z())};
}

TEST(ReadPly, ReadsWhatSavePlyWritesToTheLastBit)
{
    TriangleMesh mesh = builtInMesh("human");
    mesh.vertices[7] = {0.1, -0.0, 1e-310};
    mesh.vertices[8] = {1e6 + 1.0 / 3, -1e60, 5e-324};
    const auto file = test::outputFile("exact.ply");
    savePly(mesh, file);
    const TriangleMesh read = readMesh(file);
    EXPECT_EQ(read.triangles, mesh.triangles);
    ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    {
        EXPECT_EQ(bitsOf(read.vertices[i]), bitsOf(mesh.vertices[i])) << i;
    }
    for (const std::string& bytes : {test::asciiPly(mesh), test::binaryPly(mesh, true)})
    {
        const TriangleMesh other = parse(bytes, "human.ply");
        EXPECT_EQ(other.vertices, mesh.vertices);
        EXPECT_EQ(other.triangles, mesh.triangles);
    }
}

TEST(ReadPly, TakesTriangleStrips)
{
    const std::string head =
        kHead + kVertices +
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    EXPECT_EQ(parse(head + kCornersText + "4 0 1 3 2\n", "a.ply").triangles,
              (Triangles{{0, 1, 3}, {3, 1, 2}}));
    EXPECT_EQ(parse(head + kCornersText + "8 0 1 3 -1 1 2 3 -1\n", "a.ply").triangles,
              (Triangles{{0, 1, 3}, {1, 2, 3}}));
    // Repeated corners lead to where the next part begins.
    EXPECT_EQ(parse(head + kCornersText + "8 0 1 2 2 0 0 2 3\n", "a.ply").triangles,
              (Triangles{{0, 1, 2}, {2, 0, 3}}));
    expectUnreadable(head + kCornersText + "4 0 1 3 4\n", "a.ply",
                     "line 14: the face names vertex 4");
    expectUnreadable(head + kCornersText + "4 0 1 3 -2\n", "a.ply",
                     "line 14: the face names vertex -2");
}

TEST(ReadPly, BelievesNoCount)
{
    const auto with = [](const std::string& from, const std::string& to)
    {
        return test::replaced(
            kHead + kVertices + kFaces + "end_header\n" + kCornersText + "4 0 1 2 3\n", from, to);
    };
    expectUnreadable(with("vertex 4", "vertex 4000000000"), "a.ply", "line 3: 4000000000");
    expectUnreadable(with("face 1", "face 4000000000"), "a.ply", "line 7: 4000000000");
    expectUnreadable(with("face 1", "face -1"), "a.ply", "line 7: -1 is no count");
    expectUnreadable(with("face 1", "face 2"), "a.ply", "the file ends after 1 of 2 of element");
    expectUnreadable(with("vertex 4", "vertex 3"), "a.ply", "line 14: the file has more data");
    expectUnreadable(with("4 0 1 2 3", "4000000000 0 1 2 3"), "a.ply",
                     "line 14: a list of 4000000000");
    expectUnreadable(with("4 0 1 2 3", "-4 0 1 2 3"), "a.ply", "line 14: a list of -4");
    expectUnreadable(with("4 0 1 2 3", "4 0 1 2"), "a.ply", "line 14: ");
    expectUnreadable(with("1 1 0", "1 1"), "a.ply", "line 12: the line has too few numbers");
    expectUnreadable(with("4 0 1 2 3\n", "4 0 1 2 3\n4 0 1 2 3\n"), "a.ply",
                     "line 15: the file has more data than its header says");
    expectUnreadable(with("4 0 1 2 3", "4 0 1 2 7"), "a.ply", "line 14: the face names vertex 7");
    expectUnreadable(with("1 1 0", "1 inf 0"), "a.ply", "line 12");

    const std::string bytes = test::binaryPly(test::box(0, 1), false);
    expectUnreadable(bytes.substr(0, bytes.size() - 1), "a.ply", "only 11 bytes follow");
    expectUnreadable(test::replaced(bytes, "vertex 8", "vertex 4000000000"), "a.ply",
                     "4000000000 of element 'vertex' are promised");
}

TEST(ReadPly, TakesALineOfTheHeadThatItDoesNotKnowForAComment)
{
    expectSquare("square.ply", kHead + "Created by a program 2.47, with no word before\n" +
                                   kVertices + kFaces + "end_header\n" + kCornersText +
                                   "4 0 1 2 3\n");
}

TEST(ReadPly, RefusesHeadsThatMakeNoMesh)
{
    const std::string end = "end_header\n";
    expectUnreadable("ply\nformat ascii 1.0\n", "a.ply", "has no 'end_header'");
    expectUnreadable("ply\nformat packed 1.0\n" + end, "a.ply", "line 2: 'packed' is no format");
    expectUnreadable("ply\nelement vertex 1\n" + end, "a.ply", "line 3: 'end_header'");
    expectUnreadable(kHead + "property float x\n" + end, "a.ply", "line 3: 'property'");
    expectUnreadable(kHead + "element vertex 1\nproperty half x\n" + end, "a.ply",
                     "'half' is no type");
    expectUnreadable(kHead + "element vertex 1\nproperty float x\n" + end + "0\n", "a.ply",
                     "line 3: the vertices do not have exactly one x, y and z");
    expectUnreadable(kHead + kVertices + kVertices + end, "a.ply", "exactly one x, y and z");
    expectUnreadable(kHead + kVertices + "element face 1\nproperty list uchar int vertices\n" + end,
                     "a.ply", "vertex_indices or vertex_index");
    expectUnreadable(kHead + kVertices + "element face 1\nproperty list float int vertex_index\n" +
                         end,
                     "a.ply", "a count that is no whole number");
    expectUnreadable(kHead + kVertices + end + kCornersText, "a.ply", "a point cloud");
    expectUnreadable("plywood\n", "a.ply", "does not begin with the word 'ply'");
}

} // namespace
} // namespace frostfill

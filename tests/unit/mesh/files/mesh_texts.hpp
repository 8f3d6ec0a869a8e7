// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/files/readers.hpp"
#include "unit/mesh/mesh_samples.hpp"

#include <sstream>
#include <string>

namespace frostfill::test
{

/// What readMesh makes of a file of these bytes with this name.
inline TriangleMesh parse(const std::string& bytes, const std::string& name)
{
    return parseMesh(bytes, name);
}

/// The bytes are refused in one sentence that contains `part`.
inline void expectUnreadable(const std::string& bytes, const std::string& name,
                             const std::string& part)
{
    SCOPED_TRACE(part);
    expectRefused(ErrorCode::badData, part, [&] { (void)parse(bytes, name); });
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// The bytes are the unit square in two triangles, whatever freedom the text takes.
inline void expectSquare(const std::string& name, const std::string& bytes)
{
    SCOPED_TRACE(bytes);
    const TriangleMesh mesh = parse(bytes, name);
    EXPECT_EQ(mesh.vertices,
              (std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

/// A number with all its digits.
inline std::string exact(double value)
{
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
}

inline std::string exactPoints(const TriangleMesh& mesh, const std::string& before = "")
{
    std::string text;
    for (const auto& v : mesh.vertices)
    {
        text += before + exact(v.x()) + " " + exact(v.y()) + " " + exact(v.z()) + "\n";
    }
    return text;
}

inline std::string cornersOf(const std::array<std::uint32_t, 3>& t, std::uint32_t first)
{
    return std::to_string(t[0] + first) + " " + std::to_string(t[1] + first) + " " +
           std::to_string(t[2] + first) + "\n";
}

inline std::string exactObj(const TriangleMesh& mesh)
{
    std::string text = exactPoints(mesh, "v ");
    for (const auto& t : mesh.triangles)
    {
        text += "f " + cornersOf(t, 1);
    }
    return text;
}

inline std::string vrmlText(const TriangleMesh& mesh)
{
    std::string text =
        "#VRML V2.0 utf8\nTransform { translation 1 2 3 children [ DEF a Shape { geometry "
        "IndexedFaceSet { coord Coordinate { point [\n" +
        exactPoints(mesh) + "] } coordIndex [\n";
    for (const auto& t : mesh.triangles)
    {
        text += cornersOf(t, 0) + "-1, ";
    }
    return text + "] } } ] }\nGroup { children USE a }\n";
}

inline std::string exactOff(const TriangleMesh& mesh)
{
    std::string text = "OFF\n" + std::to_string(mesh.vertices.size()) + " " +
                       std::to_string(mesh.triangles.size()) + " 0\n" + exactPoints(mesh);
    for (const auto& t : mesh.triangles)
    {
        text += "3 " + cornersOf(t, 0);
    }
    return text;
}

inline std::string asciiPly(const TriangleMesh& mesh)
{
    std::string text = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex " +
                       std::to_string(mesh.vertices.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                       std::to_string(mesh.triangles.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n" + exactPoints(mesh);
    for (const auto& t : mesh.triangles)
    {
        text += "3 " + cornersOf(t, 0);
    }
    return text;
}

inline std::string asciiStl(const TriangleMesh& mesh)
{
    std::string text = "solid by hand\n";
    for (const auto& t : mesh.triangles)
    {
        text += "facet normal 0 0 0\n  outer loop\n";
        for (const std::uint32_t corner : t)
        {
            const auto& v = mesh.vertices[corner];
            text += "    vertex " + exact(v.x()) + " " + exact(v.y()) + " " + exact(v.z()) + "\n";
        }
        text += "  endloop\nendfacet\n";
    }
    return text + "endsolid by hand\n";
}

/// A number's bytes, in the machine's order (little-endian) or turned round.
template <typename Value>
void appendBytes(std::string& bytes, Value value, bool bigEndian = false)
{
    std::string some(reinterpret_cast<const char*>(&value), sizeof value);
    if (bigEndian)
    {
        std::reverse(some.begin(), some.end());
    }
    bytes += some;
}

inline std::string binaryStl(const TriangleMesh& mesh, std::string head = "")
{
    head.resize(80, ' ');
    std::string bytes = head;
    appendBytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles)
    {
        for (int i = 0; i < 3; ++i)
        {
            appendBytes(bytes, 0.0F);
        }
        for (const std::uint32_t corner : t)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                appendBytes(bytes, static_cast<float>(mesh.vertices[corner][axis]));
            }
        }
        appendBytes(bytes, std::uint16_t{0});
    }
    return bytes;
}

inline std::string binaryPly(const TriangleMesh& mesh, bool bigEndian)
{
    std::string bytes = std::string("ply\nformat binary_") + (bigEndian ? "big" : "little") +
                        "_endian 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                        "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                        std::to_string(mesh.triangles.size()) +
                        "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const auto& v : mesh.vertices)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            appendBytes(bytes, v[axis], bigEndian);
        }
    }
    for (const auto& t : mesh.triangles)
    {
        appendBytes(bytes, std::uint8_t{3});
        for (const std::uint32_t corner : t)
        {
            appendBytes(bytes, corner, bigEndian);
        }
    }
    return bytes;
}

/// The text in UTF-16, with its byte order mark.
inline std::string utf16(const std::string& text, bool bigEndian)
{
    std::string bytes;
    appendBytes(bytes, std::uint16_t{0xfeff}, bigEndian);
    for (const char c : text)
    {
        appendBytes(bytes, static_cast<std::uint16_t>(static_cast<unsigned char>(c)), bigEndian);
    }
    return bytes;
}

/// A copy in which each `from` is `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
    {
        text.replace(at, from.size(), to);
    }
    return text;
}

} // namespace frostfill::test

// SPDX-License-Identifier: MIT
#include "mesh/files/file_kind.hpp"

#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"

#include <algorithm>
#include <optional>

namespace frostfill
{
namespace
{

constexpr std::size_t kLooksAhead = 512; // [byte] for what no text holds
constexpr std::size_t kHeadOfXml = 4096; // [byte] in which the first element is, behind comments

struct ForeignFormat
{
    std::string_view begin; ///< of the file, or of the first element of XML
    std::string_view name;
};

constexpr std::array<ForeignFormat, 18> kForeignFormats = {{
    {"PK\x03\x04", "a ZIP archive, as 3MF files are"},
    {"\x1f\x8b", "compressed (gzip)"},
    {"Kaydara FBX Binary", "an FBX file"},
    {"; FBX", "an FBX file"},
    {"BLENDER", "a Blender file"},
    {"DRACO", "compressed with Draco"},
    {"ISO-10303-21", "a STEP file, of curved surfaces"},
    {"#VRML", "a VRML file"},
    {"# vtk", "a VTK file"},
    {"# .PCD", "a point cloud (PCD)"},
    {"LASF", "a point cloud (LAS)"},
    {"$MeshFormat", "a Gmsh file"},
    {"MeshVersionFormatted", "a Medit file"},
    {"<COLLADA", "a COLLADA file (DAE)"},
    {"<VTKFile", "a VTK file in XML, as VTP and VTU files are"},
    {"<X3D", "an X3D file"},
    {"<amf", "an AMF file"},
    {"<", "XML or a web page"},
}};

bool endsWithOff(std::string_view word)
{
    return word.ends_with("OFF") && word.size() <= 8; // STCN4nOFF at most
}

/// What the content alone tells.
std::optional<FileKind> kindByContent(std::string_view bytes)
{
    if (hasSizeOfBinaryStl(bytes))
    {
        return FileKind::binaryStl; // even if it begins with "solid", as some do
    }
    if (bytes.starts_with("glTF"))
    {
        return FileKind::gltf;
    }
    TextScanner scanner(bytes, {.comment = '#'});
    const std::string_view word = scanner.wordAnywhere();
    if (word == "ply")
    {
        return FileKind::ply;
    }
    if (word == "solid" || word == "SOLID" || word == "Solid")
    {
        // Binary files may begin with this word too.
        const bool isText = bytes.substr(0, kLooksAhead).find('\0') == std::string_view::npos;
        return isText ? FileKind::asciiStl : FileKind::binaryStl;
    }
    if (endsWithOff(word))
    {
        return FileKind::off;
    }
    return std::nullopt;
}

std::optional<FileKind> kindByEnding(std::string_view ending)
{
    if (ending == "obj")
    {
        return FileKind::obj;
    }
    if (ending == "off")
    {
        return FileKind::off; // the word OFF may be left out
    }
    if (ending == "stl")
    {
        return FileKind::binaryStl;
    }
    if (ending == "gltf" || ending == "glb")
    {
        return FileKind::gltf;
    }
    if (ending == "ply")
    {
        throw Unreadable("it does not begin with the word 'ply' as PLY files do; export the mesh "
                         "again");
    }
    return std::nullopt;
}

} // namespace

FileKind kindOf(std::string_view bytes, std::string_view ending)
{
    if (bytes.empty())
    {
        throw Unreadable("it is empty; export the mesh again");
    }
    const auto byContent = kindByContent(bytes);
    if (byContent)
    {
        return *byContent;
    }
    const std::string_view xml = bytes.substr(0, bytes.front() == '<' ? kHeadOfXml : 0);
    const auto* const stranger =
        std::find_if(kForeignFormats.begin(), kForeignFormats.end(),
                     [&](const ForeignFormat& other) {
                         return bytes.starts_with(other.begin) ||
                                xml.find(other.begin) != std::string_view::npos;
                     });
    if (stranger != kForeignFormats.end())
    {
        throw Unreadable(fmt::format("it is {}; convert the mesh to OBJ, STL, PLY, OFF or glTF",
                                     stranger->name));
    }
    const auto byEnding = kindByEnding(ending);
    if (!byEnding)
    {
        throw Unreadable(
            "its content is none of the formats that can be read, and it does not end "
            "in .obj, .stl, .ply, .off, .gltf or .glb; convert the mesh to one of these");
    }
    return *byEnding;
}

} // namespace frostfill

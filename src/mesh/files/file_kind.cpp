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

constexpr std::array<ForeignFormat, 11> kForeignFormats = {{
    {"\x1f\x8b", "compressed (gzip) twice: unpack it with gunzip"},
    {"BLENDER", "a Blender file"},
    {"DRACO", "compressed with Draco"},
    {"ISO-10303-21", "a STEP file, of curved surfaces"},
    {"#VRML", "a VRML 1.0 file"},
    {"# .PCD", "a point cloud (PCD)"},
    {"LASF", "a point cloud (LAS)"},
    {"$MeshFormat", "a Gmsh file"},
    {"MeshVersionFormatted", "a Medit file"},
    {"<amf", "an AMF file"},
    {"<", "XML or a web page"},
}};

struct KnownFormat
{
    std::string_view begin; ///< likewise
    FileKind kind;
};

constexpr std::array<KnownFormat, 9> kKnownFormats = {{{"glTF", FileKind::gltf},
                                                       {"<COLLADA", FileKind::dae},
                                                       {"Kaydara FBX Binary", FileKind::fbx},
                                                       {"; FBX", FileKind::fbx},
                                                       {"<X3D", FileKind::x3d},
                                                       {"PK\x03\x04", FileKind::threeMf},
                                                       {"# vtk", FileKind::vtk},
                                                       {"#VRML V2.0", FileKind::vrml},
                                                       {"<VTKFile", FileKind::vtp}}};

/// Of a table of beginnings, the format whose beginning a file has.
template <class Formats>
const auto* formatOf(std::string_view bytes, const Formats& formats)
{
    const std::string_view xml =
        bytes.substr(0, !bytes.empty() && bytes.front() == '<' ? kHeadOfXml : 0);
    const auto found = std::find_if(formats.begin(), formats.end(),
                                    [&](const auto& format) {
                                        return bytes.starts_with(format.begin) ||
                                               xml.find(format.begin) != std::string_view::npos;
                                    });
    return found == formats.end() ? nullptr : &*found;
}

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
    if (const auto* known = formatOf(bytes, kKnownFormats))
    {
        return known->kind;
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

std::string_view endingOfScene(FileKind kind)
{
    switch (kind)
    {
    case FileKind::dae:
        return "dae";
    case FileKind::fbx:
        return "fbx";
    case FileKind::x3d:
        return "x3d";
    case FileKind::threeMf:
        return "3mf";
    default:
        return "gltf";
    }
}

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
    if (const auto* stranger = formatOf(bytes, kForeignFormats))
    {
        throw Unreadable(fmt::format(
            "it is {}; convert the mesh to OBJ, STL, PLY, OFF, VTP or glTF", stranger->name));
    }
    const auto byEnding = kindByEnding(ending);
    if (!byEnding)
    {
        throw Unreadable(
            "its content is none of the formats that can be read, and it does not end "
            "in .obj, .stl, .ply, .off, .gltf or .glb; convert the mesh to one of these, VTP, DAE, "
            "FBX, X3D, 3MF or VRML 97");
    }
    return *byEnding;
}

} // namespace frostfill

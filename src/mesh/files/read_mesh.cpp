// SPDX-License-Identifier: MIT
#include "base/read_number.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"
#include "mesh/repair/repair_steps.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <fstream>

namespace frostfill
{
namespace
{

constexpr std::size_t kLooksAhead = 512; // [byte] for what no text holds
constexpr std::size_t kHeadOfXml = 4096; // [byte] in which the first element is, behind comments

/// A file, and what its reader has to overlook in it.
struct Source
{
    std::string_view bytes;
    const std::filesystem::path& name;
    std::vector<std::string>& remarks;
    std::vector<MeshPatch>& solids;
};
using Reader = TriangleMesh (*)(const Source&);

template <TriangleMesh (*Read)(std::string_view)>
TriangleMesh readWith(const Source& source)
{
    return Read(source.bytes);
}

TriangleMesh readGltf(const Source& source)
{
    return readScene(source.name, source.bytes, "gltf");
}

TriangleMesh readFbx(const Source& source)
{
    return readScene(source.name, source.bytes, "fbx");
}

TriangleMesh readVrml(const Source& source)
{
    return readScene(std::filesystem::path(source.name).replace_extension("x3d"),
                     x3dOfVrml(source.bytes), "x3d");
}

TriangleMesh readStlText(const Source& source)
{
    return readAsciiStl(source.bytes, source.solids);
}

struct KnownFormat
{
    std::string_view begin; ///< of the file, or of the first element of XML
    Reader reader;
};

constexpr std::array<KnownFormat, 9> kKnownFormats = {
    {{"glTF", readGltf},
     {"#VRML V2.0", readVrml},
     {"<COLLADA", [](const Source& s) { return readScene(s.name, s.bytes, "dae"); }},
     {"Kaydara FBX Binary", readFbx},
     {"; FBX", readFbx},
     {"<X3D", [](const Source& s) { return readScene(s.name, s.bytes, "x3d"); }},
     {"PK\x03\x04", [](const Source& s) { return readScene(s.name, s.bytes, "3mf"); }},
     {"# vtk", readWith<readVtk>},
     {"<VTKFile", readWith<readVtp>}}};

struct ForeignFormat
{
    std::string_view begin; ///< likewise
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

/// Of a table of beginnings, the format whose beginning a file has; null for none.
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

/// What the content alone tells; null if that is nothing.
Reader readerByContent(std::string_view bytes)
{
    if (hasSizeOfBinaryStl(bytes))
    {
        return readWith<readBinaryStl>; // even if it begins with "solid", as some do
    }
    if (const auto* known = formatOf(bytes, kKnownFormats))
    {
        return known->reader;
    }
    TextScanner scanner(bytes, {.comment = '#'});
    const std::string_view word = scanner.wordAnywhere();
    if (word == "ply")
    {
        return [](const Source& source) { return readPly(source.bytes, source.remarks); };
    }
    if (word == "solid" || word == "SOLID" || word == "Solid")
    {
        // Binary files may begin with this word too.
        const bool isText = bytes.substr(0, kLooksAhead).find('\0') == std::string_view::npos;
        return isText ? readStlText : readWith<readBinaryStl>;
    }
    return word.ends_with("OFF") && word.size() <= 8 // STCN4nOFF at most
               ? readWith<readOff>
               : nullptr;
}

/// Null for an ending that tells nothing.
Reader readerByEnding(const std::filesystem::path& name)
{
    std::string ending = name.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (ending == ".ply")
    {
        throw Unreadable("it does not begin with the word 'ply' as PLY files do; export the mesh "
                         "again");
    }
    return ending == ".obj"                        ? readWith<readObj>
           : ending == ".off"                      ? readWith<readOff> // OFF may be left out
           : ending == ".stl"                      ? readWith<readBinaryStl>
           : ending == ".gltf" || ending == ".glb" ? readGltf
                                                   : nullptr;
}

/// The reader of a file, by its content first and then by its name's ending: many files have the
/// wrong one. `bytes` as decodeText leaves them. Throws Unreadable, with the format's name if it is
/// a known one that nothing here reads.
Reader readerOf(std::string_view bytes, const std::filesystem::path& name)
{
    if (bytes.empty())
    {
        throw Unreadable("it is empty; export the mesh again");
    }
    if (const Reader byContent = readerByContent(bytes))
    {
        return byContent;
    }
    if (const auto* stranger = formatOf(bytes, kForeignFormats))
    {
        throw Unreadable(fmt::format(
            "it is {}; convert the mesh to OBJ, STL, PLY, OFF, VTP or glTF", stranger->name));
    }
    if (const Reader byEnding = readerByEnding(name))
    {
        return byEnding;
    }
    throw Unreadable("its content is none of the formats that can be read, and it does not end in "
                     ".obj, .stl, .ply, .off, .gltf or .glb; convert the mesh to one of these, "
                     "VTP, DAE, FBX, X3D, 3MF or VRML 97");
}

std::string contentOf(const std::filesystem::path& file)
{
    std::error_code ignored;
    const std::string name = file.string();
    if (!std::filesystem::exists(file, ignored))
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("there is no file '{}', and the built-in objects are {}", name,
                                builtInMeshText()));
    }
    std::ifstream stream(file, std::ios::binary);
    const std::uintmax_t size = std::filesystem::is_regular_file(file, ignored)
                                    ? std::filesystem::file_size(file, ignored)
                                    : 0;
    std::string bytes(stream && !ignored ? size : 0, '\0');
    if (!std::filesystem::is_regular_file(file, ignored) || !stream ||
        !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    {
        throw Error(ErrorCode::inputMissing, fmt::format("'{}' is not a readable file", name));
    }
    return bytes;
}

constexpr std::array<std::string_view, 14> kEndings = {".obj", ".stl", ".ply", ".off", ".gltf",
                                                       ".glb", ".dae", ".fbx", ".x3d", ".3mf",
                                                       ".vtk", ".vtp", ".vtu", ".wrl"};

bool endsAsMesh(const std::filesystem::path& file)
{
    const std::filesystem::path ending =
        file.extension() == ".gz" ? file.stem().extension() : file.extension();
    return std::find(kEndings.begin(), kEndings.end(), ending.string()) != kEndings.end();
}

std::vector<std::filesystem::path> meshesIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        if (entry.is_regular_file() && endsAsMesh(entry.path()))
        {
            files.push_back(entry.path());
        }
    }
    if (files.empty())
    {
        throw Error(ErrorCode::inputMissing,
                    fmt::format("the folder '{}' has no mesh: no file in it ends in {}",
                                folder.string(), fmt::join(kEndings, ", ")));
    }
    std::sort(files.begin(), files.end()); // the order of a folder is chance
    return files;
}

} // namespace

std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path& given)
{
    std::error_code ignored; // then it is read as a file, which says why it cannot be
    if (std::filesystem::is_directory(given, ignored))
    {
        return meshesIn(given);
    }
    const std::string name = given.string();
    if (name.find('+') == std::string::npos || std::filesystem::exists(given, ignored))
    {
        return {given};
    }
    std::vector<std::filesystem::path> files;
    for (const std::string_view part : partsOf(name, '+'))
    {
        files.emplace_back(part);
        if (!std::filesystem::is_regular_file(files.back(), ignored))
        {
            throw Error(ErrorCode::inputMissing,
                        fmt::format("there is no file '{}': give one mesh, or several files, which "
                                    "are its patches",
                                    part));
        }
    }
    return files;
}

TriangleMesh parseMesh(std::string bytes, const std::filesystem::path& file,
                       std::vector<std::string>* remarks, std::vector<MeshPatch>* solids)
{
    try
    {
        std::filesystem::path name = file;
        if (isGzip(bytes) && !hasSizeOfBinaryStl(bytes))
        {
            bytes = gunzip(bytes);
            name.replace_extension(); // of part.stl.gz
        }
        // Not a binary STL, whose free bytes may begin like a mark.
        if (!hasSizeOfBinaryStl(bytes))
        {
            bytes = decodeText(std::move(bytes));
        }
        std::vector<std::string> overlooked;
        std::vector<MeshPatch> found;
        TriangleMesh mesh = readerOf(bytes, name)({bytes, name, overlooked, found});
        if (const auto fault = findInvalidData(mesh))
        {
            throw Unreadable(*fault + "; export the mesh again");
        }
        weldEqualVertices(mesh);
        if (remarks != nullptr)
        {
            remarks->insert(remarks->end(), overlooked.begin(), overlooked.end());
        }
        if (solids != nullptr)
        {
            *solids = std::move(found);
        }
        return mesh;
    }
    catch (const Unreadable& why)
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' cannot be read as a mesh: {}", file.string(), why.what()));
    }
}

TriangleMesh readMesh(const std::filesystem::path& file, std::vector<std::string>* remarks,
                      std::vector<MeshPatch>* patches)
{
    TriangleMesh all;
    std::vector<MeshPatch> found;
    const std::vector<std::filesystem::path> files = filesOfMesh(file);
    for (const std::filesystem::path& each : files)
    {
        std::vector<MeshPatch> solids;
        TriangleMesh part = parseMesh(contentOf(each), each, remarks, &solids);
        if (solids.size() < 2)
        {
            const std::filesystem::path name = each.extension() == ".gz" ? each.stem() : each;
            solids = {{name.stem().string(), part.triangles.size()}};
        }
        found.insert(found.end(), solids.begin(), solids.end());
        if (files.size() == 1)
        {
            all = std::move(part);
            break;
        }
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const auto& [a, b, c] : part.triangles)
        {
            all.triangles.push_back({a + first, b + first, c + first});
        }
    }
    if (files.size() > 1)
    {
        weldEqualVertices(all);
    }
    if (patches != nullptr && found.size() > 1)
    {
        *patches = std::move(found);
    }
    return all;
}

} // namespace frostfill

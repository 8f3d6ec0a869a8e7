// SPDX-License-Identifier: MIT
#include "mesh/files/containers.hpp"
#include "mesh/files/file_kind.hpp"
#include "mesh/files/mesh_files.hpp"
#include "mesh/files/readers.hpp"
#include "mesh/files/text_scanner.hpp"
#include "mesh/files/unpack.hpp"
#include "mesh/repair/clean_mesh.hpp"
#include "mesh/repair/stitch_seams.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace frostfill
{
namespace
{

std::string endingOf(const std::filesystem::path& file)
{
    std::string ending = file.extension().string();
    ending.erase(0, 1);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return ending;
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

TriangleMesh parse(const std::string& bytes, FileKind kind, const std::filesystem::path& file,
                   std::vector<std::string>& remarks, std::vector<MeshPatch>& solids)
{
    switch (kind)
    {
    case FileKind::obj:
        return readObj(bytes);
    case FileKind::off:
        return readOff(bytes);
    case FileKind::ply:
        return readPly(bytes, remarks);
    case FileKind::asciiStl:
        return readAsciiStl(bytes, solids);
    case FileKind::binaryStl:
        return readBinaryStl(bytes);
    case FileKind::vtk:
        return readVtk(bytes);
    case FileKind::vtp:
        return readVtp(bytes);
    case FileKind::vrml:
        return readScene(std::filesystem::path(file).replace_extension("x3d"), x3dOfVrml(bytes),
                         "x3d");
    default:
        break;
    }
    return readScene(file, bytes, endingOfScene(kind));
}

} // namespace

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
        TriangleMesh mesh = parse(bytes, kindOf(bytes, endingOf(name)), name, overlooked, found);
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

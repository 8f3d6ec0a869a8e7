// SPDX-License-Identifier: MIT
// Room: mesh files: readers for the common formats, the PLY writer, and the built-in objects. A
// reader sees only the file that it was given.
#pragma once

#include <frostfill/mesh.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// The files of a mesh, which may be given as patches: the files of a folder that end as meshes do,
/// by name, or names with '+' between them. Any other name is that of a file, whether it is there
/// or not. Throws Error inputMissing for a folder without a mesh, and if one of several is no file.
[[nodiscard]] std::vector<std::filesystem::path> filesOfMesh(const std::filesystem::path& given);

/// readMesh of bytes in memory. `file` gives the name's ending and is named in messages;
/// only glTF is read from it. `solids` gets those of a text STL. Throws Error badData.
[[nodiscard]] TriangleMesh parseMesh(std::string bytes, const std::filesystem::path& file,
                                     std::vector<std::string>* remarks = nullptr,
                                     std::vector<MeshPatch>* solids = nullptr);

/// All built-in objects, as users write them.
[[nodiscard]] std::string builtInMeshText();

// Compressed files.

[[nodiscard]] inline bool isGzip(std::string_view bytes)
{
    return bytes.starts_with("\x1f\x8b");
}

/// Returns the content of a gzip file, of one member or several. Throws Unreadable for damaged
/// data, and for more than 256 times its size.
[[nodiscard]] std::string gunzip(std::string_view packed);

/// Appends the `size` bytes of a zlib stream. Throws Unreadable as gunzip does, and for another
/// size.
void appendInflated(std::string_view packed, std::size_t size, std::string& to);

/// Returns the size of a file's content [byte], as a gzip file tells it: at most 16 times that of
/// the file, because files may lie. 0 for no file.
[[nodiscard]] std::size_t contentSize(const std::filesystem::path& file);

// One reader for each format. All but that of scenes take the file's bytes, read numbers in double
// precision, and use memory in proportion to these bytes, whatever the file promises. They throw
// Unreadable.

/// Wavefront OBJ: v and f; all else is skipped.
[[nodiscard]] TriangleMesh readObj(std::string_view text);

/// Object File Format, with colours, normals and texture coordinates or without, not binary.
[[nodiscard]] TriangleMesh readOff(std::string_view text);

/// Polygon File Format: ascii, little-endian and big-endian, faces and triangle strips [Turk 1994].
/// Lines of text may have more values than the header says; `remarks` gets a sentence then.
[[nodiscard]] TriangleMesh readPly(std::string_view bytes, std::vector<std::string>& remarks);

/// `solids` gets those of the file, or nothing if some of its facets are no triangles.
[[nodiscard]] TriangleMesh readAsciiStl(std::string_view text, std::vector<MeshPatch>& solids);
[[nodiscard]] TriangleMesh readBinaryStl(std::string_view bytes);

/// Whether the size is exactly that of a binary STL with as many triangles as it promises.
[[nodiscard]] bool hasSizeOfBinaryStl(std::string_view bytes);

/// VTK: legacy files and files of XML, of polygons or of flat cells of an unstructured grid.
[[nodiscard]] TriangleMesh readVtk(std::string_view bytes);
[[nodiscard]] TriangleMesh readVtp(std::string_view text);

/// Scenes, whose numbers are single precision, by assimp: glTF 2.0 and GLB, with .bin files beside
/// them, COLLADA, FBX, X3D and 3MF. `ending`: gltf, dae, fbx, x3d or 3mf, as assimp knows them;
/// `bytes` are the file's content.
[[nodiscard]] TriangleMesh readScene(const std::filesystem::path& file, std::string_view bytes,
                                     std::string_view ending);

/// What VRML 97 shows, as X3D.
[[nodiscard]] std::string x3dOfVrml(std::string_view text);

} // namespace frostfill

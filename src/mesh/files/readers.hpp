// SPDX-License-Identifier: MIT
// One reader for each format. All but that of scenes take the file's bytes, read numbers in double
// precision, and use memory in proportion to these bytes, whatever the file promises. They throw
// Unreadable.
#pragma once

#include <frostfill/mesh.hpp>

#include <string>
#include <string_view>

namespace frostfill
{

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

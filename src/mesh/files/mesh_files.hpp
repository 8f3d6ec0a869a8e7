// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

#include <filesystem>
#include <string>
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

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>

namespace frostfill
{

/// readMesh of bytes in memory. `file` gives the name's ending and is named in messages;
/// only glTF is read from it. Throws Error badData.
[[nodiscard]] TriangleMesh parseMesh(std::string bytes, const std::filesystem::path& file,
                                     std::vector<std::string>* remarks = nullptr);

} // namespace frostfill

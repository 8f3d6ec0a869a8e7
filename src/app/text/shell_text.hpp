// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/shell.hpp>

#include <string>

namespace frostfill
{

/// What the option --full-mesh does.
inline constexpr const char* kFullMeshHelp =
    "Keep all triangles of a dense mesh, in place of a simplified shell";

/// The end of a line about a file: what became of its shell. Empty if it is the mesh.
[[nodiscard]] std::string describe(const ShellInFile& shell);

} // namespace frostfill

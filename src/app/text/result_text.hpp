// SPDX-License-Identifier: MIT
// Room: what commands say of what the library found, as text.
#pragma once

#include <frostfill/shell.hpp>
#include <frostfill/simulation.hpp>

#include <string>

namespace frostfill
{

/// The findings of an inspection, one line each. `volume`: of the object [unit^3].
[[nodiscard]] std::string reachText(const ReachInspection& reach, double radius, double volume);

/// What the option --full-mesh does.
inline constexpr const char* kFullMeshHelp =
    "Keep all triangles of a dense mesh, in place of a simplified shell";

/// The end of a line about a file: what became of its shell. Empty if it is the mesh.
[[nodiscard]] std::string describe(const ShellInFile& shell);

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/packing.hpp>

#include <CLI/App.hpp>

#include <string>

namespace frostfill
{

/// The end of the help of a command that reads a packing: what FILE may be.
inline constexpr const char* kPackingFiles = R"(
FILE is the directory of a run, a run.frost, a table with columns x, y, z and radius (CSV, or
separated by semicolons or spaces), extended XYZ, or a LAMMPS dump; of several moments the last.
)";

void addPackingMeshOption(CLI::App& command, std::string& mesh);

/// The mesh that is named, whose repairs are said, or else the one that came with the packing of
/// `file`. Throws Error usage where there is none.
[[nodiscard]] TriangleMesh meshOf(const Packing& packing, const std::string& file,
                                  const std::string& mesh, const LoadMeshOptions& load);

} // namespace frostfill

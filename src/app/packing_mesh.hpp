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
separated by semicolons or spaces), extended XYZ, a dump or data file of LAMMPS or LIGGGHTS, or the text
of YADE; of several moments the last.
)";

/// The options of a command that say how FILE is to be read.
struct PackingArguments
{
    double radius = 0;
    std::string columns;

    /// Throws Error usage for columns that cannot be read.
    [[nodiscard]] PackingFileOptions options() const;
};
void addPackingOptions(CLI::App& command, PackingArguments& arguments);

void addPackingMeshOption(CLI::App& command, std::string& mesh);

/// The mesh that is named, whose repairs are said, or else the one that came with the packing of
/// `file`. Throws Error usage where there is none.
[[nodiscard]] TriangleMesh meshOf(const Packing& packing, const std::string& file,
                                  const std::string& mesh, const LoadMeshOptions& load);

} // namespace frostfill

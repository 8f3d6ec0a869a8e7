// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/analysis.hpp>

#include <CLI/App.hpp>

#include <string>
#include <vector>

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

/// The container of a packing.
struct PackingPlace
{
    std::string mesh;
    std::vector<double> box; ///< its size, from 0 on, or its lowest and its highest corner
    bool repeats = false;
};
void addPackingMeshOption(CLI::App& command, PackingPlace& place);

/// The mesh that is named, whose repairs are said, or the box, or else the mesh that came with the
/// packing. Where there is none, a box around all spheres. Throws Error usage for no box.
[[nodiscard]] PackingWalls wallsOf(const Packing& packing, const PackingPlace& place,
                                   const LoadMeshOptions& load);

} // namespace frostfill

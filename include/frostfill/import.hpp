// SPDX-License-Identifier: MIT
// Room: simulations of other programs: a dump or extended XYZ becomes a run file.
#pragma once

#include <frostfill/scene.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#pragma GCC visibility push(default)
namespace frostfill
{

/// A file with the moments of a simulation, and what it does not say.
struct ImportRequest
{
    std::filesystem::path file;      ///< a dump of LAMMPS or LIGGGHTS, or extended XYZ
    std::filesystem::path directory; ///< of the run that is written
    /// Around the spheres: a file or a built-in name. It is taken as it is and may be open. Empty:
    /// the box of the file.
    std::string mesh;
    Axis up = Axis::y;              ///< axis of the mesh that points up
    std::optional<double> timeStep; ///< [s] between two steps; for a file without times
    std::optional<double> radius;   ///< [mesh unit] of all spheres of a file without radii
    bool overwrite = false;         ///< replace the run that the directory holds
};

struct ImportResult
{
    std::filesystem::path directory;
    std::string format;        ///< of the file, in a few words
    std::size_t steps = 0;     ///< frames of the run
    std::size_t repeats = 0;   ///< steps left out because they are there twice
    std::size_t spheres = 0;   ///< at the end
    std::size_t vanished = 0;  ///< spheres that are gone before the end
    std::size_t atRest = 0;    ///< at the end
    bool statesGiven = false;  ///< by the file; otherwise they follow from motion
    double begin = 0, end = 0; ///< [s]
    double smallestRadius = 0, largestRadius = 0; ///< [mesh unit]
    bool boxDrawn = false;                        ///< there was no mesh
    std::string torn; ///< why the end of the file was left out; empty if it was not
};

/// Called after each step with the number that are done and all; false stops.
using ImportProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Writes a run file with a frame for each timestep of another program, to be rendered and
/// exported like a run of our own; it cannot be resumed. Lengths are in the unit of the file, which
/// is that of the mesh. Where the file has no column `state`, a sphere is frozen from the step
/// after which its place stays within a thousandth of its radius up to the last step, and running
/// before; in a file of one step all are frozen. Spheres are numbered in the order in which they
/// appear, and by their ids among those that appear together; when one vanishes, its number goes
/// to the last one. Throws Error inputMissing; badData with file and line; usage if a time, a
/// radius or a mesh is missing; cannotCreate, writeFailed, stoppedEarly.
ImportResult importRun(const ImportRequest& request, const ImportProgress& progress = {});

} // namespace frostfill
#pragma GCC visibility pop

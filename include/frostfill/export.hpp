// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/bed.hpp>
#include <frostfill/shell.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// What other programs read. docs/exports.md has the columns of each.
enum class ExportFormat
{
    vtp,          ///< VTK PolyData a frame, spheres and mesh, and a .pvd over all: ParaView
    lammpsDump,   ///< one text file of all frames: LAMMPS, OVITO, VMD
    xyz,          ///< extended XYZ of all frames: OVITO, ASE
    glb,          ///< glTF 2.0 with an animation; each sphere is a node: Blender, F3D
    glbInstanced, ///< the packing as glTF 2.0 with EXT_mesh_gpu_instancing: three.js, Babylon.js
    csv,          ///< a text table of spheres a frame, states as numbers
    // Inputs of other programs, which go on from the packing. Friction, restitution and gravity are
    // those of the run.
    liggghts,   ///< an input script of LIGGGHTS, a data file, and the walls as STL
    lammps,     ///< an input script of LAMMPS, and a data file of atom_style sphere
    yade,       ///< a Python script of YADE, and tables of spheres and walls
    mercuryDpm, ///< a data file of MercuryDPM (format 14)
    mfix,       ///< particle_input.dat of MFiX, version 2.0
    lethe,      ///< a list of particles that Lethe inserts
    // Geometry of one frame; see BedSettings.
    stlBed,   ///< one closed surface of spheres and container
    openFoam, ///< a case of OpenFOAM
    gmsh,     ///< exact spheres and container for gmsh (OpenCASCADE)
    vti,      ///< distances and labels of voxels for VTK
    npy,      ///< the same for NumPy
};

struct ExportFormatInfo
{
    ExportFormat format;
    const char* name;    ///< on the command line
    const char* frames;  ///< selected by default: "all" or "last"
    const char* purpose; ///< for --help
};

[[nodiscard]] std::span<const ExportFormatInfo> exportFormats();
/// Throws Error usage with the nearest name, or with the name of what replaces a former format.
[[nodiscard]] const ExportFormatInfo& exportFormat(std::string_view name);

/// Options of the command `export` that only some formats take, without dashes: "measure",
/// "full-mesh", "no-shell", "lids", "contacts", "resolution", "ascii", "cell" and "voxels".
[[nodiscard]] std::span<const std::string_view> exportOptions();
/// Throws Error usage, which names the formats that do, if a format does not take one of them.
void requireOption(ExportFormat format, std::string_view option);

struct ExportRequest
{
    std::filesystem::path run; ///< a run file, or a folder that has run.frost
    ExportFormat format = ExportFormat::vtp;
    std::string frames;        ///< as --frames; empty for the format's default
    std::filesystem::path out; ///< a folder; it is made if need be
    bool overwrite = false;    ///< files of an earlier export
    /// All triangles of a dense mesh where a simplified shell would be written: in glb and
    /// glbInstanced. The other formats have the true mesh, or none.
    bool fullMesh = false;
    bool shell = true; ///< in glb and glbInstanced
    /// In liggghts, lammps and yade: lids that the mesh was closed with are walls too.
    bool lids = false;
    BedSettings bed = {}; ///< of the formats that are geometry
    /// Columns that are measured of each frame, see Column::measured, beside those of the run.
    std::vector<std::string> measured = {};
};

struct ExportResult
{
    std::vector<std::filesystem::path> files; ///< the one to open comes first
    std::size_t frames = 0;
    std::size_t spheres = 0;  ///< in the last frame
    std::size_t repeats = 0;  ///< frames left out because another shows the same moment
    std::uint64_t bytes = 0;  ///< of all files
    ShellInFile shell;        ///< of glTF; the other formats have none
    double cells = 0;         ///< of openFoam: estimate of the cells that its mesh will have
    double unitsPerMetre = 1; ///< in which the lengths of the files are
    bool unfinished = false;  ///< the run was stopped, or is still under way
};

/// Called after each frame with the number that are done and all; false stops.
using ExportProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Writes frames of a run in another format. Lengths are in the unit of the mesh, those of
/// openFoam, glb and glbInstanced in metres. Times are in seconds. Positions are those of the
/// world: a moved object and its spheres are where they were moved. Of selected frames that show
/// the same moment one is written, so that times ascend: the first of those with the last of its
/// states. Places of resting spheres are exact; those of moving ones are rounded to 1/10,000 of a
/// radius. Throws Error inputMissing or badData for a run that cannot be read, usage for a
/// selection without a frame and for an option that the format does not take, cannotCreate if a
/// file is there already, writeFailed, and stoppedEarly.
ExportResult exportRun(const ExportRequest& request, const ExportProgress& progress = {});

} // namespace frostfill
#pragma GCC visibility pop

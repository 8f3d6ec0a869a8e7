// SPDX-License-Identifier: MIT
#include "export/sphere_columns.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <fmt/format.h>

#include <array>

namespace frostfill
{
namespace
{

template <ExportFormat format>
std::unique_ptr<Exporter> makeBedExporter(const ExportedRun& run,
                                          const std::filesystem::path& folder)
{
    return makeBedExporter(format, run, folder);
}

/// All that is known of a format: who asks for one finds it here.
struct FormatEntry
{
    ExportFormatInfo info;
    MakeExporter* make;
    /// The files that it writes, the one to open first; one that begins with a dot stands for a
    /// file a frame, which ends in it, and one with a star for a file a patch of the walls.
    std::array<const char*, 3> files;
    std::string_view takes = ""; ///< of exportOptions()
    bool isGeometry = false;     ///< of one frame
    bool isInMetres = false;     ///< not in the unit of the mesh
};

constexpr std::array<std::string_view, 9> kOptions = {"measure", "full-mesh", "no-shell",
                                                      "lids",    "contacts",  "resolution",
                                                      "ascii",   "cell",      "voxels"};
constexpr std::string_view kOfGltf = "measure full-mesh no-shell";

constexpr std::array<FormatEntry, 17> kEntries = {{
    {{ExportFormat::vtp, "vtp", "all", "spheres and mesh for ParaView and VTK; open run.pvd"},
     makeVtpExporter,
     {"run.pvd", ".vtp"},
     "measure"},
    {{ExportFormat::lammpsDump, "lammps-dump", "all",
      "a dump of all frames for LAMMPS, OVITO, VMD"},
     makeLammpsDumpExporter,
     {"spheres.dump"},
     "measure"},
    {{ExportFormat::xyz, "xyz", "all", "extended XYZ of all frames for OVITO and ASE"},
     makeXyzExporter,
     {"spheres.xyz"},
     "measure"},
    {{ExportFormat::glb, "glb", "all", "an animated glTF 2.0 scene for Blender and F3D"},
     makeGlbExporter,
     {"run.glb"},
     kOfGltf,
     false,
     true},
    {{ExportFormat::glbInstanced, "glb-instanced", "last",
      "the packing as glTF 2.0 with EXT_mesh_gpu_instancing, for browsers"},
     makeGlbInstancedExporter,
     {"packing.glb"},
     kOfGltf,
     false,
     true},
    {{ExportFormat::csv, "csv", "last", "a text table of spheres for each frame, all numbers"},
     makeCsvExporter,
     {".csv"},
     "measure"},
    {{ExportFormat::liggghts, "liggghts", "last", "an input script of LIGGGHTS with its files"},
     makeLiggghtsExporter,
     {"liggghts.in", "liggghts.data", "liggghts_*.stl"},
     "lids"},
    {{ExportFormat::lammps, "lammps", "last", "an input script of LAMMPS with its data file"},
     makeLammpsExporter,
     {"lammps.in", "lammps.data"},
     "lids"},
    {{ExportFormat::yade, "yade", "last", "a Python script of YADE with its files"},
     makeYadeExporter,
     {"yade.py", "yade.txt", "yade_walls.txt"},
     "lids"},
    {{ExportFormat::mercuryDpm, "mercurydpm", "last", "the packing for readDataFile of MercuryDPM"},
     makeMercuryDpmExporter,
     {"mercurydpm.data"}},
    {{ExportFormat::mfix, "mfix", "last", "the packing as particle_input.dat of MFiX"},
     makeMfixExporter,
     {"particle_input.dat"}},
    {{ExportFormat::lethe, "lethe", "last", "the packing for the insertion method file of Lethe"},
     makeLetheExporter,
     {"particles.input"}},
    {{ExportFormat::stlBed, "stl-bed", "last", "one closed surface of spheres and container"},
     makeBedExporter<ExportFormat::stlBed>,
     {"bed.stl", "bed.stl.json"},
     "contacts resolution ascii",
     true},
    {{ExportFormat::openFoam, "openfoam", "last",
      "a case of OpenFOAM for the flow between spheres"},
     makeBedExporter<ExportFormat::openFoam>,
     {"openfoam"},
     "contacts resolution cell",
     true,
     true},
    {{ExportFormat::gmsh, "gmsh", "last", "exact spheres and container for gmsh"},
     makeBedExporter<ExportFormat::gmsh>,
     {"bed.geo", "bed.geo.json"},
     "contacts cell",
     true},
    {{ExportFormat::vti, "vti", "last", "distance and label of each voxel for VTK"},
     makeBedExporter<ExportFormat::vti>,
     {"bed.vti", "bed.vti.json"},
     "contacts voxels",
     true},
    {{ExportFormat::npy, "npy", "last", "distance and label of each voxel for NumPy"},
     makeBedExporter<ExportFormat::npy>,
     {"distance.npy", "label.npy", "volume.json"},
     "contacts voxels",
     true},
}};

/// Names of formats that there were, and what says the same.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kFormer = {
    {{"lammps-data", "lammps, whose lammps.data is for read_data"},
     {"npz", "csv, or frostfill.load in Python, which has each frame as arrays"},
     {"openmc", "csv, whose spheres openmc.model.TRISO takes"},
     {"ply", "csv, or vtp for binary files"},
     {"gmsh-bed", "gmsh"}}};

constexpr auto kFormats = []
{
    std::array<ExportFormatInfo, kEntries.size()> infos{};
    for (std::size_t i = 0; i < infos.size(); ++i)
    {
        infos[i] = kEntries[i].info;
    }
    return infos;
}();

/// exportFormats()[format] is that of the format.
static_assert(
    []
    {
        for (std::size_t i = 0; i < kEntries.size(); ++i)
        {
            if (static_cast<std::size_t>(kEntries[i].info.format) != i)
            {
                return false;
            }
        }
        return true;
    }());

const FormatEntry& entryOf(ExportFormat format)
{
    return kEntries[static_cast<std::size_t>(format)];
}

} // namespace

std::span<const std::string_view> exportOptions()
{
    return kOptions;
}

void requireOption(ExportFormat format, std::string_view option)
{
    const auto takes = [&](const FormatEntry& entry) {
        return fmt::format(" {} ", entry.takes).find(fmt::format(" {} ", option)) !=
               std::string::npos;
    };
    if (takes(entryOf(format)))
    {
        return;
    }
    std::vector<std::string_view> others;
    for (const FormatEntry& entry : kEntries)
    {
        if (takes(entry))
        {
            others.emplace_back(entry.info.name);
        }
    }
    throw Error(ErrorCode::usage,
                fmt::format("{} takes no --{}, which is for {}", entryOf(format).info.name, option,
                            fmt::join(others, ", ")));
}

bool isInMetres(ExportFormat format)
{
    return entryOf(format).isInMetres;
}

bool isGeometry(ExportFormat format)
{
    return entryOf(format).isGeometry;
}

std::span<const ExportFormatInfo> exportFormats()
{
    return kFormats;
}

const ExportFormatInfo& exportFormat(std::string_view name)
{
    std::vector<std::string> names;
    for (const ExportFormatInfo& info : kFormats)
    {
        if (info.name == name)
        {
            return info;
        }
        names.emplace_back(info.name);
    }
    for (const auto& [former, instead] : kFormer)
    {
        if (name == former)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("there is no format {} any more: use {}", former, instead));
        }
    }
    const std::string nearest = nearestName(name, names);
    throw Error(ErrorCode::usage,
                fmt::format("no format '{}'; {}", name,
                            nearest.empty() ? fmt::format("choose among {}", fmt::join(names, ", "))
                                            : fmt::format("did you mean {}?", nearest)));
}

ColumnList exportedColumns(const Snapshot& state)
{
    ColumnList exported;
    for (const Column& column : columns())
    {
        if (column.exported && (!column.isCarried() || state.values(column) != nullptr))
        {
            exported.push_back(&column);
        }
    }
    return exported;
}

ColumnList without(const ColumnList& columns, bool (*left)(const Column& column))
{
    ColumnList rest = columns;
    std::erase_if(rest, [&](const Column* column) { return left(*column); });
    return rest;
}

std::vector<MeshPatch> wallsOf(const ExportedRun& run)
{
    std::vector<MeshPatch> walls = run.patches;
    std::size_t left = run.mesh.triangles.size() - run.lids;
    for (const MeshPatch& patch : walls)
    {
        left -= patch.triangles;
    }
    if (left > 0)
    {
        walls.push_back({walls.empty() ? "walls" : "lids", left});
    }
    return walls;
}

std::vector<std::string> exportFiles(ExportFormat format, const ExportedRun& run)
{
    std::vector<std::string> names;
    for (const char* file : entryOf(format).files)
    {
        if (file == nullptr)
        {
            break;
        }
        const std::string name = file;
        const std::size_t star = name.find('*');
        if (star != std::string::npos)
        {
            for (const MeshPatch& patch : wallsOf(run))
            {
                names.push_back(std::string(name).replace(star, 1, patch.name));
            }
        }
        else if (name[0] != '.')
        {
            names.push_back(name);
        }
        else
        {
            for (const std::size_t number : run.numbers)
            {
                names.push_back(numberedName("spheres", number, file + 1));
            }
        }
    }
    return names;
}

std::unique_ptr<Exporter> makeExporter(ExportFormat format, const ExportedRun& run,
                                       const std::filesystem::path& folder)
{
    return entryOf(format).make(run, folder);
}

} // namespace frostfill

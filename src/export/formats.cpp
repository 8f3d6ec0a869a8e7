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

constexpr std::array<ExportFormatInfo, 9> kFormats = {{
    {ExportFormat::vtp, "vtp", "all", "spheres and mesh for ParaView and VTK; open run.pvd"},
    {ExportFormat::lammpsDump, "lammps-dump", "all", "a dump of all frames for LAMMPS, OVITO, VMD"},
    {ExportFormat::lammpsData, "lammps-data", "last", "the packing for read_data of LAMMPS"},
    {ExportFormat::xyz, "xyz", "all", "extended XYZ of all frames for OVITO and ASE"},
    {ExportFormat::glb, "glb", "all", "an animated glTF 2.0 scene for Blender and F3D"},
    {ExportFormat::glbInstanced, "glb-instanced", "last",
     "the packing as glTF 2.0 with EXT_mesh_gpu_instancing, for browsers"},
    {ExportFormat::ply, "ply", "last", "a binary table of spheres for each frame"},
    {ExportFormat::csv, "csv", "last", "a text table of spheres for each frame, all numbers"},
    {ExportFormat::npz, "npz", "all", "NumPy arrays of all frames in one file"},
}};

} // namespace

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

std::string numberedName(const char* what, std::size_t number, const char* ending)
{
    return fmt::format("{}_{:05}.{}", what, number, ending);
}

std::vector<std::string> exportFiles(ExportFormat format, const std::vector<std::size_t>& numbers)
{
    const auto numbered = [&](const char* ending)
    {
        std::vector<std::string> names;
        for (const std::size_t number : numbers)
        {
            names.push_back(numberedName("spheres", number, ending));
        }
        return names;
    };
    switch (format)
    {
    case ExportFormat::vtp:
    {
        std::vector<std::string> names = numbered("vtp");
        names.insert(names.begin(), "run.pvd");
        return names;
    }
    case ExportFormat::lammpsDump:
        return {"spheres.dump"};
    case ExportFormat::lammpsData:
        return {"spheres.data"};
    case ExportFormat::xyz:
        return {"spheres.xyz"};
    case ExportFormat::glb:
        return {"run.glb"};
    case ExportFormat::glbInstanced:
        return {"packing.glb"};
    case ExportFormat::ply:
        return numbered("ply");
    case ExportFormat::csv:
        return numbered("csv");
    case ExportFormat::npz:
        break;
    }
    return {"run.npz"};
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "bed/bed_files.hpp"
#include "bed/bed_summary.hpp"
#include "bed/links.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <map>
#include <utility>

namespace frostfill
{
namespace
{

/// The faces of the container; returns how many there are. Each triangle is a plane surface.
void putContainer(AtomicFile& file, const TriangleMesh& mesh)
{
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k)
    {
        const Eigen::Vector3d& p = mesh.vertices[k];
        file.write(fmt::format("Point({}) = {{{}, {}, {}}};\n", k + 1, p.x(), p.y(), p.z()));
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> lines;
    const auto line = [&](std::uint32_t from, std::uint32_t to)
    {
        const auto [entry, isNew] = lines.try_emplace(std::minmax(from, to), lines.size() + 1);
        if (isNew)
        {
            file.write(fmt::format("Line({}) = {{{}, {}}};\n", entry->second,
                                   entry->first.first + 1, entry->first.second + 1));
        }
        return fmt::format("{}{}", from < to ? "" : "-", entry->second);
    };
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
    {
        const auto& [a, b, c] = mesh.triangles[k];
        const std::string ab = line(a, b);
        const std::string bc = line(b, c);
        const std::string ca = line(c, a);
        file.write(fmt::format("Curve Loop({}) = {{{}, {}, {}}};\n", k + 1, ab, bc, ca));
    }
    // After all loops, because a surface takes the next number for a loop of its own.
    for (std::size_t k = 1; k <= mesh.triangles.size(); ++k)
    {
        file.write(fmt::format("Plane Surface({0}) = {{{0}}};\n", k));
    }
    file.write(fmt::format("Surface Loop(1) = {{1:{}}};\n", mesh.triangles.size()));
}

void putPatches(AtomicFile& file, const Bed& bed)
{
    for (std::size_t patch = 0; patch + 1 < bed.patches().size(); ++patch)
    {
        std::string list;
        for (std::size_t k = 0; k < bed.mesh().triangles.size(); ++k)
        {
            list +=
                bed.patch(k) == patch ? fmt::format("{}{}", list.empty() ? "" : ", ", k + 1) : "";
        }
        file.write(
            fmt::format("Physical Surface(\"{}\") = {{{}}};\n", bed.patches()[patch].name, list));
    }
}

/// Spheres that touch nothing are holes of the container, and nothing has to be intersected. Each
/// has one face and one loop of surfaces, which are numbered in turn.
void putHoles(AtomicFile& file, const Bed& bed)
{
    const std::size_t faces = bed.mesh().triangles.size();
    for (std::size_t k = 0; k < bed.size(); ++k)
    {
        const Eigen::Vector3d& c = bed.centre(k);
        file.write(fmt::format("Sphere({}) = {{{}, {}, {}, {}}};\n", k + 1, c.x(), c.y(), c.z(),
                               bed.treatedRadius(k)));
    }
    file.write(fmt::format("Delete {{ Volume{{1:{}}}; }}\n", bed.size()));
    file.write(fmt::format("Volume(1) = {{1:{}}};\n", bed.size() + 1));
    file.write("Physical Volume(\"fluid\") = {1};\n");
    putPatches(file, bed);
    file.write(
        fmt::format("Physical Surface(\"spheres\") = {{{}:{}}};\n", faces + 1, faces + bed.size()));
}

} // namespace

double writeGmshBed(const Bed& bed, const std::filesystem::path& folder, Files& files)
{
    (void)findLinks(bed); // refuses what is not apart
    files.push_back(folder / "bed.geo");
    AtomicFile file(files.back());
    file.write(fmt::format(
        "// Spheres in their container, by Frostfill. gmsh -3 bed.geo meshes what is between "
        "them.\n// Lengths are in the unit of the mesh, {} in a metre.\n"
        "SetFactory(\"OpenCASCADE\");\n",
        bed.unitsPerMetre()));
    const double edge = bed.settings().cell * bed.meanDiameter();
    file.write(fmt::format("Mesh.CharacteristicLengthMax = {:.9g};\n", edge));
    putContainer(file, bed.mesh());
    putHoles(file, bed);
    file.commit();
    files.push_back(folder / "bed.geo.json");
    nlohmann::ordered_json summary = bedSummary(bed);
    const double shrunk = std::pow(bed.treatedRadius(0) / bed.radius(0), 3);
    const double space = bed.containerVolume() * (1 - shrunk * (1 - bed.porosity()));
    summary["porosity_of_geometry"] = space / bed.containerVolume();
    // Of four beds in three containers this is within 30 %: gmsh refines at contacts and walls.
    const double cells = 9 * space / std::pow(edge, 3) + 150 * static_cast<double>(bed.size()) +
                         4 * static_cast<double>(bed.mesh().triangles.size());
    summary["estimated_cells"] = std::llround(cells);
    writeSummary(summary, files.back());
    return cells;
}

} // namespace frostfill

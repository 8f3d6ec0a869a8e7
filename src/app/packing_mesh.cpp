// SPDX-License-Identifier: MIT
#include "app/packing_mesh.hpp"

#include "app/progress/message.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <utility>

namespace frostfill
{

PackingFileOptions PackingArguments::options() const
{
    return {.radius = radius,
            .columns = columns.empty() ? PackingColumns{} : parsePackingColumns(columns)};
}

void addPackingOptions(CLI::App& command, PackingArguments& arguments)
{
    command
        .add_option("--radius", arguments.radius, "Radius of all spheres of a file without radii")
        ->check(CLI::NonNegativeNumber)
        ->type_name("R");
    command
        .add_option("--columns", arguments.columns,
                    "Columns of a table by name or number: x=NAME,y=NAME,z=NAME,radius=NAME (or "
                    "diameter=NAME)")
        ->type_name("COLUMNS");
}

void addPackingMeshOption(CLI::App& command, std::string& mesh)
{
    command
        .add_option("--mesh", mesh,
                    "The mesh it is in: a file, or torus, sphere, cube, human (that of the run)")
        ->type_name("MESH");
}

TriangleMesh meshOf(const Packing& packing, const std::string& file, const std::string& mesh,
                    const LoadMeshOptions& load)
{
    if (!mesh.empty())
    {
        LoadedMesh loaded = loadMesh(mesh, load);
        for (const std::string& repair : loaded.repairs)
        {
            say(fmt::format("repaired: {}\n", repair));
        }
        return std::move(loaded.mesh);
    }
    if (!packing.mesh)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("'{}' has spheres and no mesh: give the one they are in with "
                                "--mesh",
                                file));
    }
    return *packing.mesh;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "app/packing_mesh.hpp"

#include "app/progress/message.hpp"

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

void addPackingMeshOption(CLI::App& command, PackingPlace& place)
{
    command
        .add_option("--mesh", place.mesh,
                    "The mesh it is in: a file, or a built-in object such as cylinder:1,4 (that of "
                    "the run; else none)")
        ->type_name("MESH");
    auto* box = command
                    .add_option("--box", place.box,
                                "The box it is in, without a mesh: X,Y,Z from 0 on, or X,Y,Z of "
                                "the lowest corner and of the highest")
                    ->delimiter(',')
                    ->type_name("X,Y,Z[,X,Y,Z]")
                    ->excludes("--mesh");
    command.add_flag("--periodic", place.repeats, "The box repeats in all directions")->needs(box);
}

PackingWalls wallsOf(const Packing& packing, const PackingPlace& place, const LoadMeshOptions& load)
{
    if (!place.mesh.empty())
    {
        LoadedMesh loaded = loadMesh(place.mesh, load);
        for (const std::string& repair : loaded.repairs)
        {
            say(fmt::format("repaired: {}\n", repair));
        }
        return {std::move(loaded.mesh)};
    }
    if (!place.box.empty())
    {
        return wallsOfBox(place.box, place.repeats);
    }
    if (packing.mesh)
    {
        return {*packing.mesh};
    }
    say("no mesh is given, and no --box: what needs walls is left out\n");
    return wallsAround(packing);
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "app/packing_mesh.hpp"

#include "app/progress/message.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
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

namespace
{

Eigen::AlignedBox3d boxOf(const std::vector<double>& given)
{
    Eigen::AlignedBox3d box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    const std::size_t low = given.size() - 3;
    for (std::size_t axis = 0; axis < 3 && given.size() % 3 == 0 && given.size() <= 6; ++axis)
    {
        box.min()[axis] = low > 0 ? given[axis] : 0;
        box.max()[axis] = given[low + axis];
    }
    if (!(box.sizes().minCoeff() > 0))
    {
        throw Error(ErrorCode::usage,
                    "--box needs three lengths above 0, or six coordinates: those "
                    "of its lowest corner, then of its highest");
    }
    return box;
}

} // namespace

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
        return {boxMesh(boxOf(place.box)),
                place.repeats ? AnalysisBounds::periodic : AnalysisBounds::walls};
    }
    if (packing.mesh)
    {
        return {*packing.mesh};
    }
    say("no mesh is given, and no --box: what needs walls is left out\n");
    return {boxAround(packing), AnalysisBounds::none};
}

TriangleMesh boxAround(const Packing& packing)
{
    Eigen::AlignedBox3d around;
    for (std::size_t k = 0; k < packing.centres.size(); ++k)
    {
        if (packing.centres[k].allFinite())
        {
            around.extend(Eigen::Vector3d(packing.centres[k].array() - packing.radii[k]));
            around.extend(Eigen::Vector3d(packing.centres[k].array() + packing.radii[k]));
        }
    }
    if (around.isEmpty())
    {
        throw Error(ErrorCode::badData, "no sphere of the packing has a finite centre");
    }
    return boxMesh(around);
}

Packing withImages(const Packing& packing, const TriangleMesh& box)
{
    const Eigen::AlignedBox3d bounds = boundingBox(box);
    const double reach = 2 * *std::max_element(packing.radii.begin(), packing.radii.end());
    Packing all = packing;
    for (Eigen::Vector3d& centre : all.centres)
    {
        const Eigen::Array3d share = (centre - bounds.min()).array() / bounds.sizes().array();
        centre -= (share.floor() * bounds.sizes().array()).matrix();
    }
    for (int image = 0; image < 27; ++image)
    {
        const Eigen::Vector3d step(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
        for (std::size_t k = 0; k < packing.centres.size() && !step.isZero(); ++k)
        {
            const Eigen::Vector3d centre = all.centres[k] + step.cwiseProduct(bounds.sizes());
            if (bounds.exteriorDistance(centre) <= reach)
            {
                all.centres.push_back(centre);
                all.radii.push_back(packing.radii[k]);
                all.atRest.push_back(packing.atRest[k]);
            }
        }
    }
    return all;
}

} // namespace frostfill

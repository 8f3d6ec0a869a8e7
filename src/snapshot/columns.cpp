// SPDX-License-Identifier: MIT
#include <frostfill/columns.hpp>
#include <frostfill/error.hpp>
#include <frostfill/snapshot.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// No more spheres of one size touch a sphere of that size [Schütte & van der Waerden 1953].
constexpr double kKissingNumber = 12;

Column coordinate(const char* name, double (*fixed)(const SphereRow&))
{
    return {.name = name,
            .plural = "centres",
            .unit = "mesh unit",
            .frame = "mesh",
            .help = "centre of the sphere",
            .type = ColumnType::float64,
            .changes = ColumnChanges::running,
            .python = false,
            .colour = false,
            .fixed = fixed};
}

Column orientation(const char* name)
{
    return {.name = name,
            .plural = name,
            .frame = "mesh",
            .help = "component of the unit quaternion that turns a sphere from how it appeared",
            .changes = ColumnChanges::running,
            .digits = 14,
            .colour = false,
            .onRequest = true,
            .partOf = kOrientation};
}

/// What `analyse` finds of a sphere.
Column measured(const char* name, const char* plural, const char* title, const char* unit,
                const char* help, ColumnType type, double low, double high)
{
    return {.name = name,
            .plural = plural,
            .title = title,
            .unit = unit,
            .help = help,
            .type = type,
            .changes = ColumnChanges::atRest,
            .of = ColumnOf::resting,
            .low = low,
            .high = high,
            .file = false,
            .python = false,
            .measured = true};
}

/// The scales are those of what packings have: no crystal is above the upper ends.
std::vector<Column> measuredColumns()
{
    constexpr ColumnType whole = ColumnType::uint32;
    constexpr ColumnType real = ColumnType::float32;
    std::vector<Column> all = {
        measured("wall_distance", "wall_distances", "Distance from wall", "mesh unit",
                 "from the centre to the wall", real, 0, 1),
        measured("sphere_contacts", "sphere_contacts", "Contacts with spheres", "",
                 "other spheres that it touches", whole, 0, kKissingNumber),
        measured("wall_contacts", "wall_contacts", "Contacts with walls", "",
                 "pieces of wall that it touches", whole, 0, 3),
        measured("rattler", "rattlers", "Rattler", "", "1 if its contacts do not hold it",
                 ColumnType::uint8, 0, 1),
        measured("cell", "cells", "Voronoi cell", "", "0 whole, 1 cut by a wall, 2 open, 3 none",
                 ColumnType::uint8, 0, 3),
        measured("cell_volume", "cell_volumes", "Volume of the cell", "mesh unit^3",
                 "nan unless whole", real, 0, 1),
        measured("local_fraction", "local_fractions", "Packing fraction in the cell", "",
                 "share of the cell; nan likewise", real, 0.4, 0.75),
        measured("bonds", "bonds", "Bonds", "", "spheres near enough for Q6", whole, 0, 14),
        measured("q6", "q6", "Q6", "", "Q6 of its bonds", real, 0.2, 0.6),
    };
    all[0].scale = ColumnScale::depth;
    all[5].colour = false; // it has no scale that fits all packings; local_fraction has
    return all;
}

/// What each state has in a field of its own.
std::vector<Column> fixedColumns()
{
    return {
        coordinate("x", [](const SphereRow& row) { return row.centre.x(); }),
        coordinate("y", [](const SphereRow& row) { return row.centre.y(); }),
        coordinate("z", [](const SphereRow& row) { return row.centre.z(); }),
        {.name = "radius",
         .plural = "radii",
         .title = "Radius",
         .unit = "mesh unit",
         .help = "radii, in the unit of the mesh",
         .type = ColumnType::float64,
         .changes = ColumnChanges::never,
         .scale = ColumnScale::radii,
         .fixed = [](const SphereRow& row) { return row.radius; }},
        {.name = "id",
         .plural = "ids",
         .help = "order of appearance, from 0",
         .type = ColumnType::uint32,
         .changes = ColumnChanges::never,
         .python = false,
         .colour = false,
         .fixed = [](const SphereRow& row) -> double { return row.id; }},
        {.name = "state",
         .plural = "states",
         .help = "0 running, 1 frozen, 2 discarded; see frostfill.SphereState",
         .type = ColumnType::uint8,
         .changes = ColumnChanges::atRest,
         .fixed = [](const SphereRow& row) { return static_cast<double>(row.state); }},
        {.name = "group",
         .plural = "groups",
         .title = "Group",
         .help = "the group with which a sphere appeared, from 0",
         .type = ColumnType::uint32,
         .changes = ColumnChanges::never,
         .scale = ColumnScale::groups,
         .fixed = [](const SphereRow& row) -> double { return row.group; }},
        {.name = "set",
         .plural = "sets",
         .title = "Set",
         .help = "the set with which a sphere appeared, from 0",
         .type = ColumnType::uint32,
         .changes = ColumnChanges::never,
         .file = false,
         .python = false,
         .scale = ColumnScale::sets,
         .fixed = [](const SphereRow& row) -> double { return row.set; }},
        {.name = "speed",
         .plural = "speeds",
         .title = "Speed",
         .unit = "mesh unit/s",
         .help = "mesh units a second; 0 at rest",
         .type = ColumnType::float32,
         .changes = ColumnChanges::running,
         .of = ColumnOf::running,
         .digits = 11,
         .file = false,
         .scale = ColumnScale::fall,
         .fixed = [](const SphereRow& row) -> double { return row.speed; }},
        {.name = "height",
         .plural = "heights",
         .title = "Height",
         .unit = "mesh unit",
         .help = "height of the centre above the object's foot",
         .type = ColumnType::float64,
         .changes = ColumnChanges::running,
         .file = false,
         .exported = false,
         .python = false,
         .scale = ColumnScale::height,
         .fixed = [](const SphereRow& row) { return row.height; }},
    };
}

/// What only the simulation knows.
std::vector<Column> carriedOfRuns()
{
    return {
        {.name = "contacts",
         .plural = "contacts",
         .title = "Contacts",
         .help = "of a sphere at rest: other spheres at rest, and pieces of wall, whose gap to it "
                 "is below 0.01 of its radius; 0 while it runs",
         .type = ColumnType::uint32,
         .changes = ColumnChanges::atRest,
         .of = ColumnOf::resting,
         .high = kKissingNumber},
        {.name = "unbalance",
         .plural = "unbalances",
         .title = "Unbalance",
         .unit = "own weight",
         .help = "of a sphere at rest: what forces in all contacts together miss of its weight; 0 "
                 "while it runs",
         .type = ColumnType::float32,
         .changes = ColumnChanges::atRest,
         .of = ColumnOf::resting,
         .digits = 11,
         .python = false,
         .onRequest = true},
        orientation("qx"),
        orientation("qy"),
        orientation("qz"),
        orientation("qw"),
    };
}

std::deque<Column>& table()
{
    static std::deque<Column> all = []
    {
        std::deque<Column> columns;
        for (const auto& some : {fixedColumns(), carriedOfRuns(), measuredColumns()})
        {
            columns.insert(columns.end(), some.begin(), some.end());
        }
        return columns;
    }();
    return all;
}

bool isWord(const std::string& name)
{
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz_0123456789";
    return !name.empty() && name.find_first_not_of(kLetters) == std::string::npos &&
           (name.front() < '0' || name.front() > '9');
}

} // namespace

const std::deque<Column>& columns()
{
    return table();
}

const Column* findColumn(std::string_view name)
{
    const auto found = std::find_if(table().begin(), table().end(),
                                    [&](const Column& column) { return column.name == name; });
    return found != table().end() ? &*found : nullptr;
}

std::vector<std::string> colourColumns()
{
    std::vector<std::string> names;
    for (const Column& column : table())
    {
        if (column.colour)
        {
            names.push_back(column.name);
        }
    }
    return names;
}

std::vector<std::string> measuredNames()
{
    std::vector<std::string> names;
    for (const Column& column : table())
    {
        if (column.measured)
        {
            names.push_back(column.name);
        }
    }
    return names;
}

const Column& addColumn(Column column)
{
    if (!isWord(column.name))
    {
        throw Error(ErrorCode::usage,
                    fmt::format("'{}' is no name of a column: write a word of a to z, 0 to 9 and _",
                                column.name));
    }
    if (findColumn(column.name) != nullptr)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("there is a column with the name '{}' already", column.name));
    }
    if (!column.isCarried() ||
        (column.type != ColumnType::uint32 && column.type != ColumnType::float32))
    {
        throw Error(
            ErrorCode::usage,
            fmt::format("the column '{}' must be carried, as uint32 or float32", column.name));
    }
    column.plural = column.plural.empty() ? column.name : column.plural;
    column.title = column.title.empty() ? column.name : column.title;
    return table().emplace_back(std::move(column));
}

std::vector<ColumnValues> carriedColumns(std::span<const std::string> asked)
{
    std::vector<ColumnValues> carried;
    for (const Column& column : table())
    {
        const bool isAsked = std::any_of(asked.begin(), asked.end(),
                                         [&](const std::string& name)
                                         { return name == column.name || name == column.partOf; });
        if (column.isCarried() && !column.measured && (!column.onRequest || isAsked))
        {
            carried.emplace_back(column);
        }
    }
    return carried;
}

const ColumnValues* findValues(std::span<const ColumnValues> values, const Column& column)
{
    const auto found =
        std::find_if(values.begin(), values.end(),
                     [&](const ColumnValues& each) { return &each.column() == &column; });
    return found != values.end() ? &*found : nullptr;
}

double SphereRow::value(const Column& column) const
{
    if (!column.isCarried())
    {
        return column.fixed(*this);
    }
    const ColumnValues* values = findValues(carried, column);
    return values != nullptr ? values->at(id) : 0;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "output/atomic_file.hpp"
#include "output/column_text.hpp"

#include <frostfill/output.hpp>

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{
namespace
{

const char* stateName(SphereState state)
{
    switch (state)
    {
    case SphereState::running:
        return "running";
    case SphereState::frozen:
        return "frozen";
    case SphereState::discarded:
        break;
    }
    return "discarded";
}

/// The columns of spheres.csv: those of the first version in their order, then what there is more.
std::vector<const Column*> columnsOf(std::span<const ColumnValues> carried)
{
    std::vector<const Column*> all;
    for (const char* name : {"id", "group", "x", "y", "z", "radius", "state"})
    {
        all.push_back(findColumn(name));
    }
    for (const ColumnValues& values : carried)
    {
        if (values.column().file)
        {
            all.push_back(&values.column());
        }
    }
    return all;
}

} // namespace

void writeSpheresCsv(std::span<const SphereRecord> spheres, const std::filesystem::path& file)
{
    writeSpheresCsv(
        spheres.size(), [&](std::size_t id) { return spheres[id]; }, file);
}

void writeSpheresCsv(std::size_t count, const std::function<SphereRecord(std::size_t)>& sphereOf,
                     const std::filesystem::path& file, std::span<const ColumnValues> carried)
{
    const std::vector<const Column*> columns = columnsOf(carried);
    fmt::memory_buffer row;
    for (const Column* column : columns)
    {
        row.append((row.size() > 0 ? "," : "") + column->name);
    }
    row.push_back('\n');
    AtomicFile out(file);
    out.write({row.data(), row.size()});
    for (std::size_t id = 0; id < count; ++id)
    {
        const SphereRecord sphere = sphereOf(id);
        const SphereRow values{.id = static_cast<std::uint32_t>(id),
                               .centre = sphere.centre,
                               .radius = sphere.radius,
                               .state = sphere.state,
                               .group = sphere.group,
                               .carried = carried};
        row.clear();
        for (const Column* column : columns)
        {
            if (row.size() > 0)
            {
                row.push_back(',');
            }
            if (column->name == "state")
            {
                row.append(std::string_view(sphere.stray ? "stray" : stateName(sphere.state)));
            }
            else
            {
                putText(row, *column, values.value(*column));
            }
        }
        row.push_back('\n');
        out.write({row.data(), row.size()});
    }
    out.commit();
}

void writePolygonsCsv(std::span<const PolygonState> polygons, const std::filesystem::path& file)
{
    AtomicFile out(file);
    out.write("id,state\n");
    std::string row;
    for (std::size_t id = 0; id < polygons.size(); ++id)
    {
        row = fmt::format_int(id).c_str();
        row += polygons[id] == PolygonState::active ? ",active\n" : ",discarded\n";
        out.write(row);
    }
    out.commit();
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "base/threads.hpp"
#include "output/column_text.hpp"

#include <frostfill/output.hpp>

#include <fmt/format.h>

#include <algorithm>
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

void putRow(fmt::memory_buffer& text, std::span<const Column* const> columns, std::size_t id,
            const SphereRecord& sphere, std::span<const ColumnValues> carried)
{
    const SphereRow values{.id = static_cast<std::uint32_t>(id),
                           .centre = sphere.centre,
                           .radius = sphere.radius,
                           .state = sphere.state,
                           .group = sphere.group,
                           .carried = carried};
    const char* separator = "";
    for (const Column* column : columns)
    {
        text.append(std::string_view(separator));
        separator = ",";
        if (column->name == "state")
        {
            text.append(std::string_view(sphere.stray ? "stray" : stateName(sphere.state)));
        }
        else
        {
            putText(text, *column, values.value(*column));
        }
    }
    text.push_back('\n');
}

} // namespace

void writeSpheresCsv(std::span<const SphereRecord> spheres, const std::filesystem::path& file)
{
    writeSpheresCsv(
        spheres.size(), [&](std::size_t id) { return spheres[id]; }, file);
}

// Spheres are asked for in their order, and a part of their rows becomes text on each thread.
void writeSpheresCsv(std::size_t count, const std::function<SphereRecord(std::size_t)>& sphereOf,
                     const std::filesystem::path& file, std::span<const ColumnValues> carried,
                     int threads)
{
    constexpr std::size_t kRowsInPart = 1024;
    constexpr std::size_t kPartsAtOnce = 16;
    const std::vector<const Column*> columns = columnsOf(carried);
    std::string header;
    for (const Column* column : columns)
    {
        header += (header.empty() ? "" : ",") + column->name;
    }
    AtomicFile out(file);
    out.write(header + "\n");
    Threads workers(threads);
    std::vector<SphereRecord> spheres;
    std::vector<fmt::memory_buffer> texts(kPartsAtOnce);
    for (std::size_t begin = 0; begin < count; begin += spheres.size())
    {
        spheres.clear();
        while (spheres.size() < std::min(kPartsAtOnce * kRowsInPart, count - begin))
        {
            spheres.push_back(sphereOf(begin + spheres.size()));
        }
        forEachPart(workers, spheres.size(), kRowsInPart,
                    [&](std::size_t first, std::size_t last, std::size_t part)
                    {
                        for (std::size_t k = first; k < last; ++k)
                        {
                            putRow(texts[part], columns, begin + k, spheres[k], carried);
                        }
                    });
        for (fmt::memory_buffer& text : texts)
        {
            out.write({text.data(), text.size()});
            text.clear();
        }
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

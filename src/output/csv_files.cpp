// SPDX-License-Identifier: MIT
#include "output/atomic_file.hpp"

#include <frostfill/output.hpp>

#include <fmt/format.h>

#include <iterator>

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

} // namespace

void writeSpheresCsv(std::span<const SphereRecord> spheres, const std::filesystem::path& file)
{
    writeSpheresCsv(
        spheres.size(), [&](std::size_t id) { return spheres[id]; }, file);
}

void writeSpheresCsv(std::size_t count, const std::function<SphereRecord(std::size_t)>& sphereOf,
                     const std::filesystem::path& file)
{
    AtomicFile out(file);
    out.write("id,group,x,y,z,radius,state\n");
    for (std::size_t id = 0; id < count; ++id)
    {
        const SphereRecord sphere = sphereOf(id);
        fmt::memory_buffer row;
        fmt::format_to(std::back_inserter(row), "{},{},{},{},{},{},{}\n", id, sphere.group,
                       sphere.centre.x(), sphere.centre.y(), sphere.centre.z(), sphere.radius,
                       sphere.stray ? "stray" : stateName(sphere.state));
        out.write({row.data(), row.size()});
    }
    out.commit();
}

void writePolygonsCsv(std::span<const PolygonState> polygons, const std::filesystem::path& file)
{
    AtomicFile out(file);
    out.write("id,state\n");
    for (std::size_t id = 0; id < polygons.size(); ++id)
    {
        out.write(fmt::format("{},{}\n", id,
                              polygons[id] == PolygonState::active ? "active" : "discarded"));
    }
    out.commit();
}

} // namespace frostfill

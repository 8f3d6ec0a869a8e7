// SPDX-License-Identifier: MIT
#include "analysis/sphere_values.hpp"

#include <utility>

namespace frostfill
{
namespace
{

/// Copies the declaration of a column that runs have too.
Column known(const char* name)
{
    return *findColumn(name);
}

Column column(const char* name, ColumnType type, const char* unit, const char* help)
{
    return {.name = name, .unit = unit, .help = help, .type = type};
}

} // namespace

std::vector<SphereValue> sphereValues(const PackingAnalysis& analysis)
{
    std::vector<SphereValue> values;
    const auto add = [&](Column declared, auto of) {
        values.push_back({std::move(declared), std::move(of)});
    };
    const PackingAnalysis* a = &analysis;
    add(known("id"), [a](std::size_t k) { return static_cast<double>(a->ids[k]); });
    for (const auto& [name, axis] : {std::pair{"x", 0}, {"y", 1}, {"z", 2}})
    {
        add(known(name), [a, at = axis](std::size_t k) { return a->centres[k][at]; });
    }
    add(known("radius"), [a](std::size_t k) { return a->radii[k]; });
    add(column("wall_distance", ColumnType::float64, "mesh unit", "from the centre to the wall"),
        [a](std::size_t k) { return a->wallDistances[k]; });
    if (a->contacts)
    {
        add(column("sphere_contacts", ColumnType::uint32, "", "other spheres that it touches"),
            [a](std::size_t k) { return static_cast<double>(a->contacts->spheres[k]); });
        add(column("wall_contacts", ColumnType::uint32, "", "pieces of wall that it touches"),
            [a](std::size_t k) { return static_cast<double>(a->contacts->walls[k]); });
        add(column("rattler", ColumnType::uint8, "", "1 if its contacts do not hold it"),
            [a](std::size_t k) { return static_cast<double>(a->contacts->rattler[k]); });
    }
    if (a->cells)
    {
        add(column("cell", ColumnType::uint8, "", "0 whole, 1 cut by a wall, 2 open, 3 none"),
            [a](std::size_t k) { return static_cast<double>(a->cells->kinds[k]); });
        add(column("cell_volume", ColumnType::float64, "mesh unit^3", "nan unless whole"),
            [a](std::size_t k) { return a->cells->volumes[k]; });
        add(column("local_fraction", ColumnType::float64, "", "share of the cell; nan likewise"),
            [a](std::size_t k) { return a->cells->fractions[k]; });
    }
    if (a->order)
    {
        add(column("bonds", ColumnType::uint32, "", "spheres near enough for Q6"),
            [a](std::size_t k) { return static_cast<double>(a->order->bonds[k]); });
        add(column("q6", ColumnType::float64, "", "Q6 of its bonds"),
            [a](std::size_t k) { return a->order->q6[k]; });
    }
    return values;
}

} // namespace frostfill

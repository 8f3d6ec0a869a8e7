// SPDX-License-Identifier: MIT
#include "analysis/sphere_values.hpp"

#include <utility>

namespace frostfill
{
namespace
{

using Analysis = const PackingAnalysis&;

constexpr Finding kFindings[] = {
    {"wall_distance", {}, [](Analysis a, std::size_t k) { return a.wallDistances[k]; }},
    {"sphere_contacts", AnalysisKind::contacts,
     [](Analysis a, std::size_t k) -> double { return a.contacts->spheres[k]; }},
    {"wall_contacts", AnalysisKind::contacts,
     [](Analysis a, std::size_t k) -> double { return a.contacts->walls[k]; }},
    {"rattler", AnalysisKind::contacts,
     [](Analysis a, std::size_t k) -> double { return a.contacts->rattler[k]; }},
    {"cell", AnalysisKind::cells,
     [](Analysis a, std::size_t k) { return static_cast<double>(a.cells->kinds[k]); }},
    {"cell_volume", AnalysisKind::cells,
     [](Analysis a, std::size_t k) { return a.cells->volumes[k]; }},
    {"local_fraction", AnalysisKind::cells,
     [](Analysis a, std::size_t k) { return a.cells->fractions[k]; }},
    {"bonds", AnalysisKind::order,
     [](Analysis a, std::size_t k) -> double { return a.order->bonds[k]; }},
    {"q6", AnalysisKind::order, [](Analysis a, std::size_t k) { return a.order->q6[k]; }},
};

bool has(const PackingAnalysis& analysis, AnalysisKind kind)
{
    return kind == AnalysisKind::contacts ? analysis.contacts.has_value()
           : kind == AnalysisKind::cells  ? analysis.cells.has_value()
                                          : analysis.order.has_value();
}

} // namespace

std::span<const Finding> findings()
{
    return kFindings;
}

std::vector<SphereValue> sphereValues(const PackingAnalysis& analysis)
{
    std::vector<SphereValue> values;
    const auto add = [&](const char* name, auto of)
    {
        SphereValue& value = values.emplace_back(SphereValue{*findColumn(name), std::move(of)});
        value.column.type = value.column.isWhole() ? value.column.type : ColumnType::float64;
    };
    const PackingAnalysis* a = &analysis;
    add("id", [a](std::size_t k) -> double { return a->ids[k]; });
    for (const auto& [name, axis] : {std::pair{"x", 0}, {"y", 1}, {"z", 2}})
    {
        add(name, [a, at = axis](std::size_t k) { return a->centres[k][at]; });
    }
    add("radius", [a](std::size_t k) { return a->radii[k]; });
    for (const Finding& finding : kFindings)
    {
        if (!finding.kind || has(analysis, *finding.kind))
        {
            add(finding.column, [a, of = finding.of](std::size_t k) { return of(*a, k); });
        }
    }
    return values;
}

} // namespace frostfill

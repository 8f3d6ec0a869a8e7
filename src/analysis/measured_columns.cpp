// SPDX-License-Identifier: MIT
#include "analysis/measured_columns.hpp"

#include "analysis/analysis_input.hpp"
#include "analysis/sphere_values.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace frostfill
{
namespace
{

const Finding& findingOf(const Column& column)
{
    const auto all = findings();
    return *std::find_if(all.begin(), all.end(),
                         [&](const Finding& finding) { return column.name == finding.column; });
}

} // namespace

MeasuredColumns::MeasuredColumns(const TriangleMesh& mesh, const std::vector<std::string>& names,
                                 int threads)
    : mesh_(mesh)
{
    settings_.threads = threads;
    for (const std::string& name : names)
    {
        const Column* column = findColumn(name);
        if (column == nullptr || !column->measured)
        {
            throw Error(ErrorCode::usage,
                        fmt::format("'{}' is nothing that is measured of spheres; there are {}",
                                    name, fmt::join(measuredNames(), ", ")));
        }
        columns_.push_back(column);
        // Sizes cost least, where nothing has to be found but the distance of walls.
        settings_.only.push_back(findingOf(*column).kind.value_or(AnalysisKind::sizes));
    }
    checkSettings(settings_);
}

void MeasuredColumns::fill(Snapshot& snapshot, const std::vector<Eigen::Vector3d>& centres,
                           const std::vector<double>& radii)
{
    Packing packing;
    std::vector<std::size_t> ids;
    for (std::size_t k = 0; k < snapshot.states.size(); ++k)
    {
        if (snapshot.states[k] != SphereState::running && !snapshot.waits(k))
        {
            ids.push_back(k);
            packing.centres.push_back(centres[k]);
            packing.radii.push_back(radii[k]);
        }
    }
    PackingAnalysis analysis;
    if (!ids.empty())
    {
        if (!container_)
        {
            container_.emplace(mesh_, meanDiameterOf(packing.radii));
        }
        analysis = analyseIn(*container_, packing, settings_);
    }
    for (const Column* column : columns_)
    {
        ColumnValues values(*column);
        values.bits.resize(snapshot.states.size());
        for (std::size_t k = 0; k < values.bits.size() && !column->isWhole(); ++k)
        {
            values.set(k, AnalysisInput::kNothing);
        }
        for (std::size_t k = 0; k < analysis.ids.size(); ++k)
        {
            values.set(ids[analysis.ids[k]], findingOf(*column).of(analysis, k));
        }
        std::erase_if(snapshot.columns,
                      [&](const ColumnValues& each) { return &each.column() == column; });
        snapshot.columns.push_back(std::move(values));
    }
}

void MeasuredColumns::fill(Snapshot& snapshot)
{
    std::vector<Eigen::Vector3d> centres;
    for (const Eigen::Vector3f& centre : snapshot.centres)
    {
        centres.emplace_back(centre.cast<double>() + snapshot.origin);
    }
    fill(snapshot, centres, {snapshot.radii.begin(), snapshot.radii.end()});
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include <frostfill/analysis.hpp>

#include <nlohmann/json.hpp>

#include <cmath>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

/// Null for what is no number.
Json numberOrNull(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json ofPorosity(const PackingAnalysis& analysis)
{
    const PorosityProfiles& porosity = *analysis.porosity;
    Json json = {{"slabs", porosity.slabsAreExact ? "closed form" : "sampled"},
                 {"of", "the bed: what the mesh encloses below the surface"},
                 {"bed_volume", porosity.whole.objectVolume},
                 {"sampled", porosity.whole.porosity},
                 {"sampled_error", numberOrNull(porosity.whole.error)}};
    if (porosity.bulk)
    {
        json["bulk_is"] = bulkInWords();
        json["bulk_beyond"] = porosity.bulk->from;
        json["bulk"] = porosity.bulk->porosity;
        json["bulk_error"] = numberOrNull(porosity.bulk->error);
    }
    return json;
}

Json ofPairs(const PairCorrelation& pairs)
{
    const PairBin* peak = nullptr;
    for (const PairBin& bin : pairs.bins)
    {
        peak = !peak || bin.g > peak->g ? &bin : peak;
    }
    return {{"range", pairs.range},
            {"centres", pairs.centres},
            {"number_density", pairs.numberDensity},
            {"highest_g", peak ? numberOrNull(peak->g) : Json(nullptr)},
            {"highest_g_from", peak ? numberOrNull(peak->from) : Json(nullptr)},
            {"highest_g_to", peak ? numberOrNull(peak->to) : Json(nullptr)}};
}

Json ofContacts(const ContactStatistics& contacts, bool hasForces)
{
    Json json = {{"pairs", contacts.network.size()},
                 {"mean", contacts.mean},
                 {"mean_away_from_walls", numberOrNull(contacts.meanInside)},
                 {"mean_without_rattlers", numberOrNull(contacts.meanHeld)},
                 {"rattlers", contacts.rattlers}};
    if (hasForces)
    {
        json["largest_unbalance"] = contacts.unbalance;
    }
    return json;
}

Json ofCells(const CellStatistics& cells)
{
    return {{"whole", cells.whole},
            {"cut_by_walls", cells.atWall},
            {"open", cells.open},
            {"packing_fraction", numberOrNull(cells.fraction)}};
}

Json ofOrder(const OrderStatistics& order)
{
    return {{"spheres_away_from_walls", order.inside},
            {"mean_q6", numberOrNull(order.mean)},
            {"global_q6", numberOrNull(order.global)}};
}

Json settingsJson(const AnalysisSettings& settings)
{
    constexpr const char* kAxes[] = {"x", "y", "z"};
    Json json = {{"up", kAxes[static_cast<std::size_t>(settings.up)]},
                 {"bins", settings.bins},
                 {"range", settings.range},
                 {"contact_gap", settings.contactGap},
                 {"bond_length", settings.bondLength},
                 {"rattlers_below", settings.rattlersBelow},
                 {"samples", settings.samples}};
    if (settings.bounds != AnalysisBounds::walls)
    {
        json["bounds"] = settings.bounds == AnalysisBounds::none ? "none" : "periodic";
    }
    if (settings.forces)
    {
        json["forces"] = *settings.forces;
    }
    json["below"] = settings.below ? Json(*settings.below) : Json(nullptr);
    if (settings.centre)
    {
        json["centre"] = {settings.centre->x(), settings.centre->y(), settings.centre->z()};
    }
    return json;
}

} // namespace

std::string analysisSummary(const PackingAnalysis& analysis)
{
    Json json = {{"settings", settingsJson(analysis.settings)},
                 {"spheres", analysis.ids.size()},
                 {"left_out", {{"outside", analysis.outside}, {"not_finite", analysis.notFinite}}},
                 {"mesh_volume", analysis.meshVolume},
                 {"sphere_volume", analysis.sphereVolume},
                 {"packing_fraction", analysis.sphereVolume / analysis.meshVolume}};
    if (analysis.settings.bounds == AnalysisBounds::none)
    {
        json["mesh_volume"] = json["packing_fraction"] = nullptr; // of a box around the spheres
    }
    if (analysis.porosity)
    {
        json["porosity"] = ofPorosity(analysis);
    }
    if (analysis.pairs)
    {
        json["pairs"] = ofPairs(*analysis.pairs);
    }
    if (analysis.contacts)
    {
        json["contacts"] = ofContacts(*analysis.contacts, analysis.settings.forces.has_value());
    }
    if (analysis.cells)
    {
        json["cells"] = ofCells(*analysis.cells);
    }
    if (analysis.order)
    {
        json["order"] = ofOrder(*analysis.order);
    }
    if (analysis.sizes)
    {
        json["sizes"] = {{"correlation_with_height", numberOrNull(analysis.sizes->withHeight)},
                         {"correlation_with_radius", numberOrNull(analysis.sizes->withRadial)}};
    }
    return json.dump(2) + "\n";
}

} // namespace frostfill

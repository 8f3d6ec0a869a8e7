// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"

#include <frostfill/analysis.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

struct Preparation
{
    const char* name;
    double fraction;
};
constexpr Preparation kPreparations[] = {{"loosest", RestSettings::kLoosest},
                                         {"densest", RestSettings::kDensest}};
constexpr double kFrictions[] = {0.1, 0.2, 0.3, 0.6, 1};
constexpr double kContactGap = 1e-4; ///< [r] below which a gap is a contact

/// Mean number of contacts of a sphere in the bulk that is no rattler.
double contactsInBulk(const PackingAnalysis& analysis)
{
    double sum = 0;
    double held = 0;
    for (std::size_t k = 0; k < analysis.centres.size(); ++k)
    {
        if (analysis.isInBulk(k) && analysis.contacts->rattler[k] == 0)
        {
            sum += analysis.contacts->spheres[k];
            ++held;
        }
    }
    return sum / held;
}

Scene sceneOf(const Preparation& preparation, double friction, std::uint64_t spheres)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.count = spheres;
    scene.motion.mode = Motion::granular;
    scene.rest.mode = Rest::joint;
    scene.rest.friction = friction;
    scene.rest.fraction = preparation.fraction;
    return scene;
}

std::vector<std::string> rowOf(const Preparation& preparation, double friction,
                               std::uint64_t spheres, const TriangleMesh& mesh)
{
    Simulation simulation(sceneOf(preparation, friction, spheres), mesh);
    while (simulation.step())
    {
    }
    const QualityReport quality = simulation.quality();
    Snapshot snapshot;
    simulation.capture(snapshot);
    Packing packing;
    for (std::size_t k = 0; k < snapshot.centres.size(); ++k)
    {
        packing.centres.push_back(snapshot.origin + snapshot.centres[k].cast<double>());
        packing.radii.push_back(snapshot.radii[k]);
    }
    const PackingAnalysis analysis = analysePacking(
        mesh, packing, {.contactGap = kContactGap, .only = {AnalysisKind::contacts}});
    return {preparation.name,
            fmt::format("{:g}", friction),
            fmt::format("{:.4f}", quality.settling->fraction.value_or(0)),
            fmt::format("{:.2f}", contactsInBulk(analysis)),
            fmt::format("{}", packing.radii.size()),
            quality.settling->settled ? "1" : "0"};
}

void makeFrictionData(const FigureFolder& folder)
{
    const TriangleMesh mesh = builtInMesh("cube");
    const std::uint64_t spheres = folder.quick() ? 700 : 2200;
    const std::size_t frictions = folder.quick() ? 1 : std::size(kFrictions);
    Table table;
    table.headings = {"preparation", "friction", "fraction", "contacts", "spheres", "settled"};
    for (const Preparation& preparation : kPreparations)
    {
        for (std::size_t k = 0; k < frictions; ++k)
        {
            folder.progress()(table.rows.size(), std::size(kPreparations) * frictions,
                              fmt::format("{}, friction {:g}", preparation.name, kFrictions[k]));
            table.rows.push_back(rowOf(preparation, kFrictions[k], spheres, mesh));
        }
    }
    folder.write("friction.csv", table);
}

} // namespace

Figure frictionFigure()
{
    return {"friction",
            "packing fraction and contacts of grains, against friction",
            false,
            13,
            makeFrictionData,
            embedded::figure_friction};
}

} // namespace frostfill

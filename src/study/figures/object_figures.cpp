// SPDX-License-Identifier: MIT
#include "render/framing/front.hpp"
#include "run/frame_recorder.hpp"
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/figures/panels.hpp"

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace frostfill
{
namespace
{

constexpr std::uint64_t kObjectSpheres = 2000;
constexpr std::uint64_t kQuickObjectSpheres = 60;

constexpr std::size_t kStages = 4;
constexpr int kStageSide = 300; // pixels; object-stages.gp and object-cutaways.gp have these too
constexpr int kCutSide = 380;
constexpr int kObjectStrip = 30;

/// Of the wedge that is taken away, where the camera looks [degree].
constexpr double kHalfWedge = 45;

struct ObjectPanel
{
    Scene scene;
    TriangleMesh mesh;
};

ObjectPanel objectPanel(const FigureFolder& folder, int side)
{
    ObjectPanel subject{presetScene(Preset::fast, folder.object()), {}};
    subject.scene.spheres.count = folder.quick() ? kQuickObjectSpheres : kObjectSpheres;
    makePanel(subject.scene, side);
    subject.scene.style.look = Look::clean; // hatches suit the paper's coarse meshes only
    subject.scene.style.palette = paletteOf(Look::clean);
    subject.mesh = loadMesh(subject.scene.object.mesh).mesh;
    return subject;
}

void makeStages(const FigureFolder& folder)
{
    const ObjectPanel subject = objectPanel(folder, kStageSide);
    std::vector<std::size_t> spheres;
    for (std::size_t stage = 1; stage < kStages; ++stage)
    {
        spheres.push_back(*subject.scene.spheres.count * stage / kStages);
    }
    std::vector<FigureState> moments = statesOf(subject.scene, subject.mesh, spheres);
    moments.push_back(endOf(subject.scene, subject.mesh));
    Table table;
    table.headings = {"column", "spheres", "running", "frozen", "discarded", "polygons_discarded"};
    for (std::size_t column = 0; column < moments.size(); ++column)
    {
        const Snapshot& state = moments[column].snapshot;
        table.rows.push_back({fmt::format("{}", column), fmt::format("{}", state.states.size()),
                              fmt::format("{}", state.running), fmt::format("{}", state.frozen),
                              fmt::format("{}", state.discarded),
                              fmt::format("{}", state.discardedPolygons)});
    }
    folder.write("stages.csv", table);
    folder.write("stages-panels.png", joinPanels(drawStates(subject.scene, subject.mesh, moments),
                                                 kStages, kObjectStrip));
}

void makeCutaways(const FigureFolder& folder)
{
    ObjectPanel subject = objectPanel(folder, kCutSide);
    Scene& scene = subject.scene;
    const double azimuth =
        frontAzimuth(subject.mesh, renderSettings(scene, ColourRange{}).up.normalized());
    scene.style.cutaway.kind = Cutaway::Kind::wedge;
    scene.style.cutaway.from = azimuth - kHalfWedge;
    scene.style.cutaway.to = azimuth + kHalfWedge;
    const std::vector<FigureState> end = {endOf(scene, subject.mesh)};
    Table table;
    table.headings = {"column", "label"};
    std::vector<Image> panels;
    for (const auto& [by, label] : {std::pair("state", "by state"),
                                    {"set", "by set (first dark to last bright)"},
                                    {"height", "by height"}})
    {
        scene.style.colourBy = by;
        table.rows.push_back({fmt::format("{}", panels.size()), label});
        panels.push_back(drawStates(scene, subject.mesh, end).front());
    }
    folder.write("cutaways.csv", table);
    folder.write("cutaways-panels.png", joinPanels(panels, panels.size(), kObjectStrip));
}

/// A row for each set of a run.
template <typename Row>
Table tableOfSets(const FigureFolder& folder, Row row)
{
    ObjectPanel subject = objectPanel(folder, kStageSide);
    subject.scene.spheres.untilFull = true;
    Simulation simulation(subject.scene, subject.mesh);
    while (simulation.step())
    {
    }
    Snapshot state;
    simulation.capture(state);
    Table table;
    std::size_t present = 0;
    for (const SetRecord& set : simulation.sets())
    {
        present += set.spheres;
        table.rows.push_back(row(subject.mesh, state, set, present));
    }
    return table;
}

std::string percent(double share)
{
    return fmt::format("{:.3f}", 100 * share);
}

void makeDiscards(const FigureFolder& folder)
{
    Table table = tableOfSets(
        folder,
        [](const TriangleMesh& mesh, const Snapshot&, const SetRecord& set, std::size_t present)
        {
            const auto share = [](std::size_t part, std::size_t whole)
            { return percent(static_cast<double>(part) / static_cast<double>(whole)); };
            return std::vector<std::string>{fmt::format("{}", present),
                                            share(set.discarded, present),
                                            share(set.discardedPolygons, mesh.triangles.size())};
        });
    table.headings = {"spheres", "discarded_spheres_percent", "discarded_polygons_percent"};
    folder.write("discards.csv", table);
}

void makeVolume(const FigureFolder& folder)
{
    double volume = 0;
    Table table = tableOfSets(
        folder,
        [&](const TriangleMesh& mesh, const Snapshot& state, const SetRecord&, std::size_t present)
        {
            volume = volume > 0 ? volume : inspectInterior(mesh).volume;
            double filled = 0;
            for (std::size_t i = 0; i < std::min(present, state.radii.size()); ++i)
            {
                const auto radius = static_cast<double>(state.radii[i]);
                filled += 4 * M_PI / 3 * radius * radius * radius;
            }
            return std::vector<std::string>{fmt::format("{}", present), percent(filled / volume)};
        });
    table.headings = {"spheres", "filled_percent"};
    folder.write("volume.csv", table);
}

} // namespace

std::span<const Figure> objectFigures()
{
    static const std::array kFigures = {
        Figure{"stages", "the object while it fills, in four stages", false, 3, makeStages,
               embedded::figure_object_stages},
        Figure{"cutaways", "the object cut open, by state, set and height", false, 2, makeCutaways,
               embedded::figure_object_cutaways},
        Figure{"discards", "share of spheres and polygons that are discarded", false, 2,
               makeDiscards, embedded::figure_object_discards},
        Figure{"volume", "share of the volume that is filled", false, 2, makeVolume,
               embedded::figure_object_volume},
    };
    return kFigures;
}

} // namespace frostfill

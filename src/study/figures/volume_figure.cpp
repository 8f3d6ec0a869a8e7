// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/figures/pair_table.hpp"
#include "study/figures/panels.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr int kVolumeSide = 340; // pixels; volume.gp has it too

void makeVolumeData(const FigureFolder& folder)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.search = {SphereSearch::allPairs, PolygonSearch::grid};
    scene.freezing.everySets = 1;
    if (folder.quick())
    {
        scene.spheres.count = 60;
    }
    makePanel(scene, kVolumeSide);
    const TriangleMesh mesh = builtInMesh("torus");
    const std::size_t spheres[] = {*scene.spheres.count * 3 / 4};

    Scene kept = scene;
    kept.discard.rule = DiscardRule::none;
    const std::vector<FigureState> frozen = statesOf(kept, mesh, spheres);
    const std::vector<FigureState> discarded = statesOf(scene, mesh, spheres);
    const std::vector<Image> panels = {drawStates(kept, mesh, frozen).front(),
                                       drawStates(scene, mesh, discarded).front()};
    folder.write("volume-panels.png", joinPanels(panels, 2, 0));
    folder.write("volume-pairs.csv", pairTable(discarded.front().snapshot));

    Table table;
    table.headings = {"panel", "spheres", "running", "frozen", "discarded", "tests_a_step"};
    for (const FigureState* moment : {&frozen.front(), &discarded.front()})
    {
        table.rows.push_back({moment == &frozen.front() ? "frozen" : "discarded",
                              fmt::format("{}", moment->snapshot.states.size()),
                              fmt::format("{}", moment->snapshot.running),
                              fmt::format("{}", moment->snapshot.frozen),
                              fmt::format("{}", moment->snapshot.discarded),
                              fmt::format("{}", moment->sphereTests)});
    }
    folder.write("volume.csv", table);
}

} // namespace

Figure volumeFigure()
{
    return {"volume",
            "PAPER, Figure 1: a filled volume, frozen, discarded, and which pairs are tested",
            false,
            1,
            makeVolumeData,
            embedded::figure_volume};
}

} // namespace frostfill

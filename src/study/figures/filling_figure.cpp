// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/figures/panels.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr std::size_t kColumns = 5;
constexpr int kFillingSide = 190; // pixels; filling.gp has both
constexpr int kFillingStrip = 26;

void makeFillingData(const FigureFolder& folder)
{
    Table table;
    table.headings = {"object",  "column", "row",       "spheres",
                      "running", "frozen", "discarded", "polygons_discarded"};
    std::vector<Image> panels;
    std::size_t row = 0;
    for (const std::string object : {"torus", "sphere", "cube", "human"})
    {
        Scene scene = presetScene(Preset::paper, object);
        scene.search = {SphereSearch::grid, PolygonSearch::grid};
        if (folder.quick())
        {
            scene.spheres.count = 40;
        }
        makePanel(scene, kFillingSide);
        std::vector<std::size_t> spheres;
        for (std::size_t column = 1; column < kColumns; ++column)
        {
            spheres.push_back(*scene.spheres.count * column / kColumns);
        }
        const TriangleMesh mesh = builtInMesh(object);
        std::vector<FigureState> moments = statesOf(scene, mesh, spheres);
        moments.push_back(endOf(scene, mesh));
        for (std::size_t column = 0; column < moments.size(); ++column)
        {
            const Snapshot& state = moments[column].snapshot;
            table.rows.push_back({object, fmt::format("{}", column), fmt::format("{}", row),
                                  fmt::format("{}", state.states.size()),
                                  fmt::format("{}", state.running), fmt::format("{}", state.frozen),
                                  fmt::format("{}", state.discarded),
                                  fmt::format("{}", state.discardedPolygons)});
        }
        for (Image& image : drawStates(scene, mesh, moments))
        {
            panels.push_back(std::move(image));
        }
        ++row;
    }
    folder.write("filling.csv", table);
    folder.write("filling-panels.png", joinPanels(panels, kColumns, kFillingStrip));
}

} // namespace

Figure fillingFigure()
{
    return {"filling",       "the four objects while they fill",
            false,           3,
            makeFillingData, embedded::figure_filling};
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "study/figures/panels.hpp"

#include "run/frame_recorder.hpp"
#include "run/frame_timing.hpp"

#include <frostfill/renderer.hpp>
#include <frostfill/simulation.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

std::uint64_t sphereTests(const OperationCounts& counts)
{
    return counts.runningRunningTests + counts.runningFrozenTests;
}

/// Sets as large as the scale of colours by set has to be.
ColourRange rangeOf(std::span<const FigureState> moments)
{
    double last = 1;
    for (const FigureState& moment : moments)
    {
        last = std::max(last, static_cast<double>(moment.snapshot.set));
    }
    return {0, last};
}

} // namespace

std::vector<FigureState> statesOf(const Scene& scene, const TriangleMesh& mesh,
                                  std::span<const std::size_t> spheres)
{
    const double wait = fallTime(scene, inspectMesh(mesh)) / 2;
    Simulation simulation(scene, mesh);
    std::vector<FigureState> moments;
    double reached = -1;
    OperationCounts before;
    FigureState now;
    const auto take = [&]
    {
        simulation.capture(now.snapshot);
        moments.push_back(now);
        reached = -1;
    };
    while (moments.size() < spheres.size() && simulation.step())
    {
        now.sphereTests = sphereTests(simulation.operations() - before);
        before = simulation.operations();
        if (reached < 0 && simulation.sphereCount() >= spheres[moments.size()])
        {
            reached = simulation.time();
        }
        if (reached >= 0 && simulation.time() - reached >= wait)
        {
            take();
        }
    }
    while (moments.size() < spheres.size())
    {
        take();
    }
    return moments;
}

FigureState endOf(const Scene& scene, const TriangleMesh& mesh)
{
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    FigureState moment;
    simulation.capture(moment.snapshot);
    return moment;
}

std::vector<Image> drawStates(const Scene& scene, const TriangleMesh& mesh,
                              std::span<const FigureState> moments)
{
    Renderer renderer(mesh, renderSettings(scene, rangeOf(moments)));
    std::vector<Image> images(moments.size());
    for (std::size_t i = 0; i < moments.size(); ++i)
    {
        renderer.render(moments[i].snapshot, images[i]);
    }
    return images;
}

Image joinPanels(std::span<const Image> panels, std::size_t columns, int strip)
{
    const Image& first = panels.front();
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    Image joined;
    joined.width = first.width * static_cast<int>(columns);
    const int height = first.height + strip;
    const auto rowHeight = static_cast<std::size_t>(height);
    joined.height = static_cast<int>(rowHeight * rows);
    joined.channels = first.channels;
    const auto bytes = static_cast<std::size_t>(first.width) * first.channels;
    joined.pixels.assign(bytes * columns * rowHeight * rows, 255);
    for (std::size_t i = 0; i < panels.size(); ++i)
    {
        for (int y = 0; y < first.height; ++y)
        {
            const std::size_t row = i / columns * rowHeight + y;
            std::copy_n(panels[i].at(0, y), bytes,
                        joined.pixels.begin() +
                            static_cast<std::ptrdiff_t>((row * columns + i % columns) * bytes));
        }
    }
    return joined;
}

void makePanel(Scene& scene, int side)
{
    scene.size = {side, side};
    scene.style.look = Look::paper;
    scene.style.palette = paletteOf(Look::paper);
    scene.style.legend = false;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "study/picture_timing.hpp"

#include "study/frame_recorder.hpp"

#include <frostfill/simulation.hpp>

#include <chrono>

namespace frostfill
{
namespace
{

/// The step in the middle of each set. Runs are repeatable, so a first one tells.
std::vector<std::uint64_t> middleSteps(const Scene& scene, const TriangleMesh& mesh)
{
    Simulation simulation(scene, mesh);
    while (simulation.step())
    {
    }
    std::vector<std::uint64_t> middles;
    std::uint64_t begin = 0;
    for (const SetRecord& set : simulation.sets())
    {
        middles.push_back(begin + (set.steps + 1) / 2);
        begin += set.steps;
    }
    return middles;
}

class PictureClock
{
public:
    PictureClock(const TriangleMesh& mesh, const Scene& scene)
        : renderer_(mesh, renderSettings(scene))
    {
    }

    PictureMs draw(const Simulation& simulation)
    {
        simulation.capture(snapshot_);
        const StageTimes before = renderer_.times();
        renderer_.render(snapshot_, image_);
        const StageTimes& after = renderer_.times();
        const auto start = std::chrono::steady_clock::now();
        const auto png = encodePng(image_);
        const auto end = std::chrono::steady_clock::now();
        return {1000 * (after[Stage::rendering] - before[Stage::rendering]),
                1000 * (after[Stage::readback] - before[Stage::readback]),
                std::chrono::duration<double, std::milli>(end - start).count()};
    }
    [[nodiscard]] const std::string& description() const { return renderer_.description(); }

private:
    Renderer renderer_;
    Snapshot snapshot_;
    Image image_;
};

} // namespace

std::vector<PictureMs> timePictures(const Scene& scene, const TriangleMesh& mesh,
                                    std::string& renderer)
{
    const std::vector<std::uint64_t> middles = middleSteps(scene, mesh);
    PictureClock clock(mesh, scene);
    renderer = clock.description();
    Simulation simulation(scene, mesh);
    std::vector<PictureMs> pictures;
    while (pictures.size() < middles.size() && simulation.step())
    {
        const std::uint64_t middle = middles[pictures.size()];
        if (simulation.steps() < middle)
            continue;
        static_cast<void>(clock.draw(simulation));
        simulation.step();
        pictures.push_back(clock.draw(simulation));
    }
    return pictures;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "lab/finish_run.hpp"

#include "base/processor_time.hpp"
#include "simulation/engine/make_engine.hpp"
#include "simulation/quality/quality.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

/// Overlaps of running spheres, with each other and with what is at rest.
class MovingOverlaps
{
public:
    void look(const World& world)
    {
        largest_ = 0;
        sum_ = 0;
        pairs_ = 0;
        const RunningSpheres& running = world.spheres.running();
        const SphereGrid& resting = world.spheres.resting();
        for (std::uint32_t k = 0; k < running.size(); ++k)
        {
            const Eigen::Vector3d& p = running.position[k];
            const double radius = running.radius[k];
            if (!p.allFinite())
            {
                continue;
            }
            for (std::uint32_t l = k + 1; l < running.size(); ++l)
            {
                meet(p, radius, running.position[l], running.radius[l]);
            }
            resting.forEachNear(p, radius + 1,
                                [&](std::uint32_t row)
                                { meet(p, radius, resting[row].position(), resting[row].radius); });
        }
        ++looks_;
        largestSum_ += largest_;
        means_ += pairs_ > 0 ? sum_ / static_cast<double>(pairs_) : 0;
    }
    [[nodiscard]] double meanLargest() const { return largestSum_ / std::max(1.0, looks_); }
    [[nodiscard]] double mean() const { return means_ / std::max(1.0, looks_); }

private:
    void meet(const Eigen::Vector3d& a, double radiusOfA, const Eigen::Vector3d& b,
              double radiusOfB)
    {
        const double depth = radiusOfA + radiusOfB - (a - b).norm();
        if (depth <= 0)
        {
            return;
        }
        const double share = depth / std::min(radiusOfA, radiusOfB);
        largest_ = std::max(largest_, share);
        sum_ += share;
        ++pairs_;
    }

    double largest_ = 0;
    double sum_ = 0;
    std::size_t pairs_ = 0;
    double looks_ = 0;
    double largestSum_ = 0;
    double means_ = 0;
};

} // namespace

Scene studyScene(Preset preset, const std::string& mesh, double radius)
{
    Scene scene = presetScene(preset, mesh);
    scene.spheres.radius = radius;
    scene.spheres.count.reset();
    scene.threads = 1;
    if (preset == Preset::paper)
    {
        scene.search = {SphereSearch::grid, PolygonSearch::grid};
    }
    return scene;
}

Finished finishRun(const Scene& scene, const TriangleMesh& mesh, double lookEvery)
{
    Finished run;
    ProcessorClock clock;
    MovingOverlaps overlaps;
    run.world = std::make_unique<World>(scene, mesh);
    const auto engine = makeEngine(*run.world);
    double nextLook = lookEvery;
    while (engine->step())
    {
        if (lookEvery > 0 && run.world->clock.time >= nextLook)
        {
            const double before = ProcessorClock::now();
            overlaps.look(*run.world);
            nextLook += lookEvery;
            clock.leaveOut(before);
        }
    }
    run.seconds = clock.seconds();
    run.quality = examine(*run.world);
    run.movingOverlap = overlaps.meanLargest();
    run.meanMovingOverlap = overlaps.mean();
    return run;
}

} // namespace frostfill

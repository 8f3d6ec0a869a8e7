// SPDX-License-Identifier: MIT
#include "study/error_finish.hpp"
#include "study/error_runs.hpp"

#include "simulation/make_engine.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr double kLookEvery = 0.5; // [sqrt(r/g)]
constexpr int kDefaultSweeps = MotionSettings{}.sweeps;

struct StepMethod
{
    const char* name;
    const char* rivals;
    Preset preset;
    Integrator integrator;
    Motion motion;
};
constexpr StepMethod kStepMethods[] = {
    {"fast", "fall", Preset::fast, Integrator::explicitEuler, Motion::fall},
    {"fast skip", "skip", Preset::fast, Integrator::explicitEuler, Motion::skip},
    {"paper", "fall", Preset::paper, Integrator::explicitEuler, Motion::fall},
    {"paper semi-implicit", "fall", Preset::paper, Integrator::semiImplicitEuler, Motion::fall},
};

ErrorPoint stepRun(const StepMethod& method, double factor, int sweeps, std::uint64_t count,
                   int repeats)
{
    constexpr double kRadius = 0.1;
    Scene scene = studyScene(method.preset, "cube", kRadius);
    scene.spheres.count = count;
    scene.motion.integrator = method.integrator;
    scene.motion.mode = method.motion;
    scene.motion.sweeps = sweeps;
    const TriangleMesh mesh = builtInMesh("cube");
    double step = 0;
    {
        World world(scene, mesh);
        (void)makeEngine(world); // chooses the default step
        step = factor * world.dt;
        if (factor != 1)
            scene.motion.dt = step * world.frame.time;
    }
    Finished run = finishRun(scene, mesh, kLookEvery);
    for (int again = 1; again < repeats; ++again)
        run.seconds = std::min(run.seconds, finishRun(scene, mesh, kLookEvery).seconds);
    const auto spheres = static_cast<double>(run.world->spheres.size());
    const double unsupported = static_cast<double>(run.quality.unsupported) / spheres;
    const bool fast = method.preset == Preset::fast;
    return {"steps",
            method.name,
            fast ? fmt::format("step x{:g}, sweeps {}", factor, sweeps)
                 : fmt::format("step x{:g}", factor),
            fast && factor == 1 && sweeps == kDefaultSweeps,
            run.seconds,
            // What is wrong with the motion and with what it leaves hanging in the air.
            run.movingOverlap + unsupported,
            {step, static_cast<double>(fast ? sweeps : 1), run.movingOverlap,
             run.meanMovingOverlap, run.quality.maxOverlap, run.quality.meanOverlap, unsupported,
             run.quality.energyGain, run.quality.energyExcess,
             static_cast<double>(run.quality.centresOutside)},
            false,
            method.rivals};
}

} // namespace

void addStepRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    const std::uint64_t count = quick ? 100 : 600;
    const int repeats = 3;
    for (const StepMethod& method : kStepMethods)
        for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
            for (const int sweeps : {1, 2, 4, 8, 16})
            {
                const bool fast = method.preset == Preset::fast;
                // The preset fast divides steps that are longer than twice its default.
                const bool ofUse = fast ? factor <= (method.motion == Motion::skip ? 1 : 2)
                                        : sweeps == kDefaultSweeps;
                if (ofUse && (!quick || (factor >= 0.5 && factor <= 4 && sweeps != 2 && sweeps != 8)))
                    tasks.emplace_back([=] { return stepRun(method, factor, sweeps, count, repeats); });
            }
}

} // namespace frostfill

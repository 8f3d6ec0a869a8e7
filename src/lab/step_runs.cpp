// SPDX-License-Identifier: MIT
#include "lab/finish_run.hpp"
#include "lab/study.hpp"
#include "simulation/engine/make_engine.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

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

/// Means over a few seeds.
ErrorPoint stepRun(const StepMethod& method, double factor, int sweeps, std::uint64_t count)
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
        step = factor * world.clock.dt;
        if (factor != 1)
        {
            scene.motion.dt = step * world.frame.time;
        }
    }
    // What a single sphere does by chance would decide the time of a single run.
    std::array<double, 8> sums{};
    double seconds = 0;
    const std::uint64_t seeds = method.preset == Preset::fast ? 12 : 3; // it takes that much longer
    const auto runs = static_cast<double>(seeds);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    {
        scene.seed = seed;
        const Finished run = finishRun(scene, mesh, kLookEvery);
        seconds += run.seconds / runs;
        const QualityReport& q = run.quality;
        const double numbers[] = {run.movingOverlap,
                                  run.meanMovingOverlap,
                                  q.maxOverlap,
                                  q.meanOverlap,
                                  static_cast<double>(q.unsupported) /
                                      static_cast<double>(run.world->spheres.size()),
                                  q.energyGain,
                                  q.energyExcess,
                                  static_cast<double>(q.centresOutside)};
        for (std::size_t k = 0; k < std::size(numbers); ++k)
        {
            sums[k] += numbers[k] / runs;
        }
    }
    const bool fast = method.preset == Preset::fast;
    return {method.name,
            fast ? fmt::format("step x{:g}, sweeps {}", factor, sweeps)
                 : fmt::format("step x{:g}", factor),
            method.rivals,
            fast && factor == 1 && sweeps == kDefaultSweeps,
            seconds,
            // What is wrong with the motion and with what it leaves hanging in the air.
            sums[0] + sums[4],
            {step, static_cast<double>(fast ? sweeps : 1), sums[0], sums[1], sums[2], sums[3],
             sums[4], sums[5], sums[6], sums[7]}};
}

} // namespace

ErrorStudy measureSteps(bool quick, const LabProgress& progress)
{
    ErrorStudy study{"steps",
                     "overlap while moving [r] + unsupported share",
                     {"step", "sweeps", "moving_overlap", "mean_moving_overlap", "max_overlap",
                      "mean_overlap", "unsupported_share", "energy_gain", "energy_excess",
                      "outside"},
                     {}};
    const std::uint64_t count = quick ? 100 : 600;
    std::vector<std::function<ErrorPoint()>> runs;
    for (const StepMethod& method : kStepMethods)
    {
        for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
        {
            for (const int sweeps : {1, 2, 4, 8, 16})
            {
                const bool fast = method.preset == Preset::fast;
                // The preset fast divides steps that are longer than twice its default.
                const bool ofUse = fast ? factor <= (method.motion == Motion::skip ? 1 : 2)
                                        : factor >= 0.25 && sweeps == kDefaultSweeps;
                if (ofUse &&
                    (!quick || (factor >= 0.5 && factor <= 4 && sweeps != 2 && sweeps != 8)))
                {
                    runs.emplace_back([=] { return stepRun(method, factor, sweeps, count); });
                }
            }
        }
    }
    for (const auto& run : runs) // one after another: their times count
    {
        study.points.push_back(run());
        const ErrorPoint& point = study.points.back();
        progress(study.points.size(), runs.size(), point.curve + ", " + point.setting);
    }
    return study;
}

} // namespace frostfill

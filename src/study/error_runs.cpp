// SPDX-License-Identifier: MIT
#include "study/error_runs.hpp"

#include "simulation/make_engine.hpp"
#include "simulation/quality.hpp"
#include "study/bulk_packing.hpp"
#include "study/stress_meshes.hpp"

#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <initializer_list>
#include <limits>
#include <memory>

namespace frostfill
{
namespace
{

/// Of all the program's threads, so that it does not depend on what else the machine does.
double processorSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Scene sceneOf(Preset preset, const char* mesh, double radius)
{
    Scene scene = presetScene(preset, mesh);
    scene.spheres.radius = radius;
    scene.spheres.count.reset();
    scene.threads = 1;
    if (preset == Preset::paper)
        scene.search = {SphereSearch::grid, PolygonSearch::grid}; // the same bits, sooner
    return scene;
}

/// A run to its end, with its quality and time.
struct Finished
{
    std::unique_ptr<World> world;
    QualityReport quality;
    double greatestOverlap = 0; ///< [r] seen while it ran
    double seconds = 0;
};

Finished finish(const Scene& scene, const TriangleMesh& mesh, std::uint64_t stepsPerLook = 0)
{
    Finished run;
    double looking = 0;
    const double start = processorSeconds();
    run.world = std::make_unique<World>(scene, mesh);
    const auto engine = makeEngine(*run.world);
    while (engine->step())
        if (stepsPerLook > 0 && run.world->steps % stepsPerLook == 0)
        {
            const double before = processorSeconds();
            run.greatestOverlap = std::max(run.greatestOverlap, examine(*run.world).maxOverlap);
            looking += processorSeconds() - before;
        }
    run.seconds = processorSeconds() - start - looking;
    run.quality = examine(*run.world);
    run.greatestOverlap = std::max(run.greatestOverlap, run.quality.maxOverlap);
    return run;
}

struct StepMethod
{
    const char* name;
    Preset preset;
    Integrator integrator;
    Motion motion;
};
constexpr StepMethod kStepMethods[] = {
    {"fast", Preset::fast, Integrator::explicitEuler, Motion::fall},
    {"fast skip", Preset::fast, Integrator::explicitEuler, Motion::skip},
    {"paper", Preset::paper, Integrator::explicitEuler, Motion::fall},
    {"paper semi-implicit", Preset::paper, Integrator::semiImplicitEuler, Motion::fall},
};

ErrorPoint stepRun(const StepMethod& method, double factor, std::uint64_t count)
{
    constexpr double kRadius = 0.1;
    Scene scene = sceneOf(method.preset, "cube", kRadius);
    scene.spheres.count = count;
    scene.motion.integrator = method.integrator;
    scene.motion.mode = method.motion;
    const TriangleMesh mesh = builtInMesh("cube");
    if (factor != 1)
    {
        World world(scene, mesh);
        (void)makeEngine(world); // chooses the default step
        scene.motion.dt = factor * world.dt * world.frame.time;
    }
    const Finished run = finish(scene, mesh, 40);
    const auto spheres = static_cast<double>(run.world->spheres.size());
    return {"steps",
            method.name,
            fmt::format("step x{:g}", factor),
            factor == 1 && method.motion == Motion::fall && method.preset == Preset::fast,
            run.seconds,
            // What is wrong with the result: overlap and what hangs in the air.
            run.quality.maxOverlap + static_cast<double>(run.quality.unsupported) / spheres,
            {run.quality.maxOverlap, run.quality.meanOverlap, run.greatestOverlap,
             static_cast<double>(run.quality.unsupported) / spheres, run.quality.energyGain,
             run.quality.energyExcess, static_cast<double>(run.quality.centresOutside)},
            false};
}

/// The farthest that a sphere ends from where it ends without discards [r]; infinite when their
/// numbers differ.
double deviation(const World& a, const World& b)
{
    if (a.spheres.size() != b.spheres.size())
        return std::numeric_limits<double>::infinity();
    double farthest = 0;
    for (std::size_t id = 0; id < a.spheres.size(); ++id)
        farthest = std::max(farthest, (a.spheres.position(id) - b.spheres.position(id)).norm());
    return farthest;
}

ErrorPoint discardRun(Preset preset, const char* object, std::uint64_t count,
                      const std::function<void(Scene&)>& change, const std::string& setting)
{
    const TriangleMesh mesh = builtInMesh(object);
    Scene scene = presetScene(preset, object);
    scene.threads = 1;
    scene.spheres.count = count;
    scene.discard.rule = DiscardRule::none;
    const Finished without = finish(scene, mesh);
    change(scene);
    const Finished with = finish(scene, mesh);
    const World& world = *with.world;
    const double far = deviation(world, *without.world);
    return {
        "discards",
        preset == Preset::fast ? "exact" : "paper",
        setting,
        scene.discard.rule == presetScene(preset, object).discard.rule &&
            scene.discard.epsilon == DiscardSettings{}.epsilon &&
            scene.discard.closeness == DiscardSettings{}.closeness,
        with.seconds,
        far,
        {static_cast<double>(world.discardedCount) / static_cast<double>(world.spheres.size()),
         static_cast<double>(world.discardedPolygons) / static_cast<double>(world.polygons.size()),
         without.seconds, static_cast<double>(with.quality.centresOutside),
         with.quality.maxOverlap},
        false};
}

ErrorPoint volumeRun(const std::string& object, double x)
{
    const TriangleMesh mesh = loadMesh(object).mesh;
    const MeshReport report = inspectMesh(mesh);
    const double radius = x * report.volume / report.area;
    Scene scene = sceneOf(Preset::fast, object.c_str(), radius);
    scene.motion.mode = Motion::skip;
    const Finished run = finish(scene, mesh);
    const double truth = run.quality.meshVolume;
    const double raw = run.quality.sphereVolume / truth - 1;
    const double corrected = run.quality.volumeEstimate / truth - 1;
    return {"volume",
            object,
            fmt::format("rS/V {:g}", x),
            false,
            run.seconds,
            std::abs(corrected),
            {x, static_cast<double>(run.world->spheres.size()), raw, corrected,
             run.quality.sphereVolume / truth, run.quality.sphereVolume, truth},
            false};
}

ErrorPoint layerRun(Motion motion, std::uint32_t setSize, double diameters)
{
    const double half = diameters / 2;
    const TriangleMesh mesh = boxMesh({-half, -half, -half}, {half, half, half}, 4);
    Scene scene = sceneOf(Preset::fast, "cube", 0.5);
    scene.motion.mode = motion;
    scene.spheres.groupSize = setSize;
    scene.spheres.groupsPerSet = 1;
    const Finished run = finish(scene, mesh);
    const BulkPacking bulk = bulkPacking(*run.world, 4 * 2);
    // The error is what is missing to random close packing.
    constexpr double kRandomClose = 0.639;
    const double layers = setSize / (1.15 * diameters * diameters);
    return {"layers",
            motion == Motion::skip ? "fast skip" : "fast",
            fmt::format("{} a set", setSize),
            false,
            run.seconds,
            kRandomClose - bulk.fraction,
            {layers, bulk.fraction, bulk.contacts, static_cast<double>(bulk.spheres),
             static_cast<double>(run.quality.unsupported) /
                 static_cast<double>(run.world->spheres.size())},
            false};
}

} // namespace

void addStepRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    const std::uint64_t count = quick ? 100 : 600;
    for (const StepMethod& method : kStepMethods)
        for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0})
            if (!quick || (factor >= 0.5 && factor <= 4))
                tasks.emplace_back([=] { return stepRun(method, factor, count); });
}

void addDiscardRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    const std::uint64_t count = quick ? 100 : 300;
    const auto addPaper = [&](const char* name, double DiscardSettings::*setting,
                              std::initializer_list<double> values)
    {
        for (const double value : values)
            tasks.emplace_back(
                [=]
                {
                    return discardRun(
                        Preset::paper, "torus", count,
                        [=](Scene& scene)
                        {
                            scene.discard.rule = DiscardRule::paper;
                            scene.discard.*setting = value;
                        },
                        fmt::format("{} {:g} r", name, value));
                });
    };
    addPaper("epsilon", &DiscardSettings::epsilon, {0.5, 1.0, 2.0, 4.0, 8.0});
    addPaper("closeness", &DiscardSettings::closeness, {0.1, 1.0, 2.0, 4.0});
    for (const char* object : {"torus", "sphere", "cube", "human"})
        tasks.emplace_back(
            [=]
            {
                return discardRun(
                    Preset::fast, object, count,
                    [](Scene& scene) { scene.discard.rule = DiscardRule::exact; },
                    fmt::format("exact, {}", object));
            });
}

void addVolumeRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    for (const char* object : {"torus", "sphere", "cube", "human"})
        for (const double x : {0.6, 0.43, 0.3, 0.214, 0.15, 0.107, 0.075, 0.053})
            if (!quick || (x >= 0.2 && x < 0.5))
                tasks.emplace_back([=] { return volumeRun(object, x); });
}

void addLayerRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    const double diameters = quick ? 12 : 25;
    for (const std::uint32_t setSize : {7u, 70u, 210u, 700u, 2100u, 7000u})
        if (!quick || setSize <= 210)
            tasks.emplace_back([=] { return layerRun(Motion::fall, setSize, diameters); });
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "study/error/error_runs.hpp"

#include "study/error/error_finish.hpp"
#include "study/stability/stress_meshes.hpp"

#include <frostfill/analysis.hpp>
#include <frostfill/simulation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <limits>

namespace frostfill
{
namespace
{

constexpr std::uint32_t kUsualSet = 70; // what the preset fast takes in a cube of this size, about

/// The farthest that a sphere ends from where it ends without discards [r]; infinite when their
/// numbers differ.
double deviation(const World& a, const World& b)
{
    if (a.spheres.size() != b.spheres.size())
    {
        return std::numeric_limits<double>::infinity();
    }
    double farthest = 0;
    for (std::size_t id = 0; id < a.spheres.size(); ++id)
    {
        farthest = std::max(farthest, (a.spheres.position(id) - b.spheres.position(id)).norm());
    }
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
    const Finished without = finishRun(scene, mesh);
    change(scene);
    const Finished with = finishRun(scene, mesh);
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
        {static_cast<double>(world.spheres.discardedCount()) /
             static_cast<double>(world.spheres.size()),
         static_cast<double>(world.discardedPolygons) / static_cast<double>(world.polygons.size()),
         without.seconds, static_cast<double>(with.quality.centresOutside),
         with.quality.maxOverlap},
        false,
        ""};
}

struct BulkPacking
{
    double fraction = 0;
    double contacts = 0; ///< mean number a sphere of gaps below 1 % of a diameter
    double spheres = 0;  ///< whose centres are there
};

BulkPacking bulkPacking(const World& world)
{
    Packing packing;
    for (std::size_t id = 0; id < world.spheres.size(); ++id)
    {
        packing.centres.push_back(world.spheres.position(id));
        packing.radii.push_back(world.spheres.radius(id));
    }
    const PackingAnalysis analysis = analysePacking(
        world.surface.mesh(), packing,
        {.contactGap = 0.02, .only = {AnalysisKind::porosity, AnalysisKind::contacts}});
    BulkPacking bulk;
    for (std::size_t k = 0; k < analysis.ids.size(); ++k)
    {
        if (analysis.isInBulk(k))
        {
            bulk.contacts += analysis.contacts->spheres[k];
            ++bulk.spheres;
        }
    }
    bulk.contacts /= std::max(bulk.spheres, 1.0);
    bulk.fraction = analysis.porosity->bulk ? 1 - analysis.porosity->bulk->porosity : 0;
    return bulk;
}

ErrorPoint layerRun(bool bySet, std::uint32_t setSize, double diameters)
{
    const double half = diameters / 2;
    const TriangleMesh mesh = boxMesh({-half, -half, -half}, {half, half, half}, 4);
    Scene scene = studyScene(Preset::fast, "cube", 0.5);
    scene.motion.restitution = 0; // as the packings have it that we compare with
    scene.freezing.rule = bySet ? FreezingRule::bySet : FreezingRule::oneByOne;
    scene.spheres.groupSize = setSize;
    scene.spheres.groupsPerSet = 1;
    const Finished run = finishRun(scene, mesh);
    const BulkPacking bulk = bulkPacking(*run.world);
    // The error is what is missing to random close packing.
    constexpr double kRandomClose = 0.639;
    const double layers = setSize / (1.15 * diameters * diameters);
    return {"layers",
            bySet ? "by set" : "one by one",
            fmt::format("{} a set", setSize),
            !bySet && setSize == kUsualSet,
            run.seconds,
            kRandomClose - bulk.fraction,
            {layers, bulk.fraction, bulk.contacts, bulk.spheres, run.quality.maxOverlap,
             static_cast<double>(run.world->counts.overdue),
             static_cast<double>(run.quality.unsupported) /
                 static_cast<double>(run.world->spheres.size())},
            false,
            ""};
}

} // namespace

void addDiscardRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    const std::uint64_t count = quick ? 100 : 300;
    const auto addPaper = [&](const char* name, double DiscardSettings::*setting,
                              std::initializer_list<double> values)
    {
        for (const double value : values)
        {
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
        }
    };
    addPaper("epsilon", &DiscardSettings::epsilon, {0.5, 1.0, 2.0, 4.0, 8.0});
    addPaper("closeness", &DiscardSettings::closeness, {0.1, 1.0, 2.0, 4.0});
    for (const char* object : {"torus", "sphere", "cube", "human"})
    {
        tasks.emplace_back(
            [=]
            {
                return discardRun(
                    Preset::fast, object, count,
                    [](Scene& scene) { scene.discard.rule = DiscardRule::exact; },
                    fmt::format("exact, {}", object));
            });
    }
}

void addLayerRuns(std::vector<ErrorTask>& tasks, bool quick)
{
    const double diameters = quick ? 14 : 25;
    for (const bool bySet : {true, false})
    {
        for (const std::uint32_t setSize : {7u, 20u, 70u, 210u, 400u, 700u, 1400u, 2100u})
        {
            if (!quick || setSize == 7 || setSize == 70 || setSize == 210)
            {
                tasks.emplace_back([=] { return layerRun(bySet, setSize, diameters); });
            }
        }
    }
}

} // namespace frostfill

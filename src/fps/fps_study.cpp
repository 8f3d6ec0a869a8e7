// SPDX-License-Identifier: MIT
#include "fps/fps_study.hpp"

#include "base/statistics.hpp"
#include "fps/fps_run.hpp"
#include "fps/picture_timing.hpp"

#include <frostfill/mesh.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// The counted values of one quantity of a run.
template <typename Wanted>
void append(const FpsRun& run, std::size_t warmUp, double FpsStep::*quantity,
            std::vector<double>& values, const Wanted& wanted)
{
    for (std::size_t i = std::min(warmUp, run.steps.size()); i < run.steps.size(); ++i)
    {
        if (wanted(run.steps[i]))
        {
            values.push_back(run.steps[i].*quantity);
        }
    }
}

constexpr auto kAll = [](const FpsStep&) { return true; };

template <typename Wanted>
Distribution overRuns(const std::vector<FpsRun>& runs, std::size_t warmUp,
                      double FpsStep::*quantity, const Wanted& wanted)
{
    std::vector<double> values;
    for (const FpsRun& run : runs)
    {
        append(run, warmUp, quantity, values, wanted);
    }
    return describe(std::move(values));
}

template <typename Wanted>
RepeatedMean meanOverRuns(const std::vector<FpsRun>& runs, std::size_t warmUp,
                          double FpsStep::*quantity, const Wanted& wanted)
{
    std::vector<double> means;
    for (const FpsRun& run : runs)
    {
        std::vector<double> values;
        append(run, warmUp, quantity, values, wanted);
        means.push_back(mean(values));
    }
    return meanOfRepeats(means);
}

std::uint32_t placeOf(std::uint32_t set, const Scene& scene)
{
    const std::uint32_t every = scene.freezing.everySets;
    return every > 0 ? set % every + 1 : 1;
}

std::vector<FpsSet> setsOf(const std::vector<FpsRun>& runs, std::size_t warmUp, const Scene& scene)
{
    std::vector<FpsSet> sets;
    for (const FpsRunSet& ran : runs.front().sets)
    {
        FpsSet set;
        set.set = static_cast<std::uint32_t>(sets.size());
        set.place = placeOf(set.set, scene);
        const auto inSet = [&](const FpsStep& step) { return step.set == set.set; };
        set.sphereSphere = overRuns(runs, warmUp, &FpsStep::sphereSphereMs, inSet);
        set.spherePolygon = overRuns(runs, warmUp, &FpsStep::spherePolygonMs, inSet);
        set.step = overRuns(runs, warmUp, &FpsStep::stepMs, inSet);
        set.running = ran.running;
        set.frozen = ran.frozen;
        set.discarded = ran.discarded;
        set.discardedPolygons = ran.discardedPolygons;
        sets.push_back(set);
    }
    return sets;
}

std::vector<FpsPlace> placesOf(const std::vector<FpsRun>& runs, std::size_t warmUp,
                               const Scene& scene, const std::vector<FpsSet>& sets)
{
    std::vector<FpsPlace> places;
    const std::size_t count =
        std::min<std::size_t>(sets.size(), std::max(1U, scene.freezing.everySets));
    for (std::uint32_t place = 1; place <= count; ++place)
    {
        const auto there = [&](const FpsStep& step) { return placeOf(step.set, scene) == place; };
        FpsPlace result;
        result.place = place;
        for (const FpsSet& set : sets)
        {
            if (set.place == place)
            {
                result.running = std::max(result.running, set.running);
            }
        }
        result.spherePolygon = meanOverRuns(runs, warmUp, &FpsStep::spherePolygonMs, there);
        result.sphereSphere = meanOverRuns(runs, warmUp, &FpsStep::sphereSphereMs, there);
        places.push_back(result);
    }
    return places;
}

FpsMethodResult summarise(FpsMethod method, const std::vector<FpsRun>& runs, std::size_t warmUp,
                          const Scene& scene)
{
    FpsMethodResult result;
    result.method = method;
    result.sphereSphere = overRuns(runs, warmUp, &FpsStep::sphereSphereMs, kAll);
    result.spherePolygon = overRuns(runs, warmUp, &FpsStep::spherePolygonMs, kAll);
    result.step = overRuns(runs, warmUp, &FpsStep::stepMs, kAll);
    result.sphereSphereMean = meanOverRuns(runs, warmUp, &FpsStep::sphereSphereMs, kAll);
    result.spherePolygonMean = meanOverRuns(runs, warmUp, &FpsStep::spherePolygonMs, kAll);
    result.stepMean = meanOverRuns(runs, warmUp, &FpsStep::stepMs, kAll);
    result.sets = setsOf(runs, warmUp, scene);
    if (method != FpsMethod::fast)
    {
        result.places = placesOf(runs, warmUp, scene, result.sets);
    }
    const FpsRun& last = runs.back();
    result.frozen = last.frozen;
    result.discarded = last.discarded;
    result.discardedPolygons = last.discardedPolygons;
    result.stateHash = last.stateHash;
    return result;
}

/// Draws what the request wants drawn.
void timeObjectPictures(const FpsRequest& request, const TriangleMesh& mesh, FpsObject& object,
                        std::string& renderer)
{
    const auto& methods = request.methods;
    PictureTiming timing(object.scene, mesh);
    renderer = timing.description();
    // The paper's method has the same states whatever its search: the grid is there soonest.
    if (std::any_of(methods.begin(), methods.end(),
                    [](FpsMethod method) { return method != FpsMethod::fast; }))
    {
        object.paperPictures = timing.timeRun(sceneFor(object.scene, FpsMethod::grid));
    }
    if (std::find(methods.begin(), methods.end(), FpsMethod::fast) != methods.end())
    {
        object.fastPictures = timing.timeRun(sceneFor(object.scene, FpsMethod::fast));
    }
}

FpsObject measureObject(const Scene& scene, const FpsRequest& request, std::string& renderer,
                        const std::function<void(const std::string&)>& say)
{
    const LoadedMesh mesh = loadMesh(scene.object.mesh, scene.object.load);
    FpsObject object;
    object.scene = scene;
    object.triangles = mesh.report.triangles;

    // Methods take turns, so that what disturbs the machine for a while disturbs all of them.
    std::vector<std::vector<FpsRun>> runs(request.methods.size());
    for (std::size_t repeat = 0; repeat < request.repeats; ++repeat)
    {
        say(fmt::format("{}: run {} of {}", scene.name, repeat + 1, request.repeats));
        for (std::size_t i = 0; i < request.methods.size(); ++i)
        {
            runs[i].push_back(timeRun(sceneFor(scene, request.methods[i]), mesh.mesh));
        }
    }
    for (std::size_t i = 0; i < request.methods.size(); ++i)
    {
        object.methods.push_back(
            summarise(request.methods[i], runs[i], request.warmUpSteps, scene));
    }
    object.spheres = runs.front().front().spheres;
    object.radius = runs.front().front().radius;

    if (request.pictures)
    {
        say(fmt::format("{}: pictures", scene.name));
        timeObjectPictures(request, mesh.mesh, object, renderer);
    }
    return object;
}

} // namespace

const char* methodName(FpsMethod method)
{
    constexpr const char* kNames[] = {"loop", "list", "tree", "grid", "fast"};
    return kNames[static_cast<std::size_t>(method)];
}

PictureMs& PictureMs::operator+=(const PictureMs& other)
{
    spheres += other.spheres;
    samples += other.samples;
    render += other.render;
    readback += other.readback;
    encode += other.encode;
    osmesa += other.osmesa;
    return *this;
}

PictureMs PictureMs::over(double count) const
{
    return {spheres / count,  samples / count, render / count,
            readback / count, encode / count,  osmesa / count};
}

const FpsPictures* FpsObject::picturesOf(FpsMethod method) const
{
    const FpsPictures& pictures = method == FpsMethod::fast ? fastPictures : paperPictures;
    return pictures.sets.empty() ? nullptr : &pictures;
}

Scene sceneFor(const Scene& scene, FpsMethod method)
{
    Scene result = scene;
    result.preset = method == FpsMethod::fast ? Preset::fast : Preset::paper;
    result.motion.mode = Motion::fall;
    if (method == FpsMethod::fast)
    {
        if (result.discard.rule == DiscardRule::paper)
        {
            result.discard.rule = DiscardRule::exact;
        }
        return result;
    }
    if (result.discard.rule == DiscardRule::exact)
    {
        result.discard.rule = DiscardRule::paper;
    }
    const SphereSearch spheres =
        method == FpsMethod::grid ? SphereSearch::grid : SphereSearch::allPairs;
    constexpr PolygonSearch kPolygons[] = {PolygonSearch::loop, PolygonSearch::list,
                                           PolygonSearch::quadtree, PolygonSearch::grid};
    result.search = {spheres, kPolygons[static_cast<std::size_t>(method)]};
    return result;
}

FramesPerSecond framesPerSecond(double stepMs, const PictureMs* picture)
{
    FramesPerSecond result;
    const auto rate = [](double ms) { return ms > 0 ? 1000 / ms : 0; };
    result.simulation = rate(stepMs);
    if (picture)
    {
        result.drawing = rate(stepMs + picture->render);
        result.readback = rate(stepMs + picture->render + picture->readback);
        result.png = rate(stepMs + picture->render + picture->readback + picture->encode);
    }
    return result;
}

FpsResult measureFps(const FpsRequest& request, const std::function<void(const std::string&)>& say)
{
    FpsResult result;
    result.request = request;
    for (const Scene& scene : request.scenes)
    {
        result.objects.push_back(measureObject(scene, request, result.renderer, say));
    }
    return result;
}

} // namespace frostfill

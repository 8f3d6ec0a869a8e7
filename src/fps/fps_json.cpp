// SPDX-License-Identifier: MIT
#include "fps/fps_report.hpp"
#include "fps/paper_numbers.hpp"
#include "run/run_files.hpp"

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

Json distributionJson(const Distribution& values)
{
    return {{"mean", values.mean},   {"median", values.median}, {"p95", values.p95},
            {"p99", values.p99},     {"least", values.least},   {"greatest", values.greatest},
            {"frames", values.count}};
}

Json repeatedJson(const RepeatedMean& value)
{
    return {{"mean", value.mean}, {"half_width_95", value.halfWidth}, {"fastest_run", value.least}};
}

Json rateJson(double stepMs, const PictureMs* picture)
{
    const FramesPerSecond fps = framesPerSecond(stepMs, picture);
    Json json = {{"simulation", fps.simulation}};
    if (picture)
    {
        json.update({{"drawing", fps.drawing}, {"readback", fps.readback}, {"png", fps.png}});
    }
    return json;
}

Json pictureJson(const PictureMs& picture)
{
    return {{"spheres_ms", picture.spheres}, {"with_samples_ms", picture.samples},
            {"render_ms", picture.render},   {"readback_ms", picture.readback},
            {"png_ms", picture.encode},      {"osmesa_ms", picture.osmesa}};
}

Json setJson(const FpsSet& set, const FpsPictures* pictures)
{
    const PictureMs* picture =
        pictures && set.set < pictures->sets.size() ? &pictures->sets[set.set] : nullptr;
    return {{"set", set.set},
            {"place", set.place},
            {"running", set.running},
            {"frozen", set.frozen},
            {"discarded", set.discarded},
            {"polygons_discarded", set.discardedPolygons},
            {"sphere_polygon_ms", distributionJson(set.spherePolygon)},
            {"sphere_sphere_ms", distributionJson(set.sphereSphere)},
            {"step_ms", distributionJson(set.step)},
            {"frames_per_second", rateJson(set.step.mean, picture)}};
}

Json methodJson(const FpsMethodResult& method, const FpsObject& object)
{
    const FpsPictures* pictures = object.picturesOf(method.method);
    Json json = {{"search", methodName(method.method)},
                 {"step_ms", distributionJson(method.step)},
                 {"step_ms_of_runs", repeatedJson(method.stepMean)},
                 {"frames_per_second",
                  rateJson(method.stepMean.mean, pictures ? &pictures->mean : nullptr)}};
    // The fast engine tests polygons and spheres at rest together, along one path.
    if (method.method != FpsMethod::fast)
    {
        json["sphere_polygon_ms"] = distributionJson(method.spherePolygon);
        json["sphere_polygon_ms_of_runs"] = repeatedJson(method.spherePolygonMean);
        json["sphere_sphere_ms"] = distributionJson(method.sphereSphere);
        json["sphere_sphere_ms_of_runs"] = repeatedJson(method.sphereSphereMean);
    }
    for (const FpsPlace& place : method.places)
    {
        json["places"].push_back({{"place", place.place},
                                  {"running", place.running},
                                  {"sphere_polygon_ms", repeatedJson(place.spherePolygon)},
                                  {"sphere_sphere_ms", repeatedJson(place.sphereSphere)}});
    }
    json["frozen"] = method.frozen;
    json["discarded"] = method.discarded;
    json["polygons_discarded"] = method.discardedPolygons;
    json["state_hash"] = method.stateHash;
    for (const FpsSet& set : method.sets)
    {
        json["sets"].push_back(setJson(set, pictures));
    }
    return json;
}

Json paperJson(const PaperNumbers* paper)
{
    if (!paper)
    {
        return nullptr;
    }
    Json json;
    for (const PaperRange& range : paper->spherePolygonMs)
    {
        json["sphere_polygon_ms"].push_back({range.low, range.high});
    }
    json["polygons_discarded_percent"] = paper->polygonsDiscarded;
    return json;
}

Json objectJson(const FpsObject& object)
{
    Json json = {{"object", object.scene.name},
                 {"triangles", object.triangles},
                 {"spheres", object.spheres},
                 {"radius", object.radius},
                 {"group_size", object.scene.spheres.groupSize},
                 {"groups_per_set", object.scene.spheres.groupsPerSet},
                 {"freeze_every", object.scene.freezing.everySets},
                 {"paper", paperJson(paperNumbers(object.scene.object.mesh))}};
    for (const FpsMethod method : {FpsMethod::grid, FpsMethod::fast})
    {
        if (const FpsPictures* pictures = object.picturesOf(method))
        {
            Json& picture = json["pictures"][method == FpsMethod::fast ? "fast" : "paper"];
            picture = pictureJson(pictures->mean);
            picture["running"] = pictures->running;
            picture["width"] = object.scene.size.width;
            picture["height"] = object.scene.size.height;
            picture["samples"] = object.scene.samples;
        }
    }
    for (const FpsMethodResult& method : object.methods)
    {
        json["searches"].push_back(methodJson(method, object));
    }
    return json;
}

} // namespace

Json fpsJson(const FpsResult& result)
{
    Json json = {{"format", "frostfill fps 1"},
                 {"machine", machineJson(result.renderer)},
                 {"runs", result.request.repeats},
                 {"warm_up_steps", result.request.warmUpSteps}};
    for (const FpsObject& object : result.objects)
    {
        json["objects"].push_back(objectJson(object));
    }
    return json;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "run/run_head.hpp"

#include "output/scene_json.hpp"
#include "run/frame_painter.hpp"
#include "run/frame_timing.hpp"

#include <frostfill/error.hpp>
#include <frostfill/fill.hpp>
#include <frostfill/picture_settings.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>

namespace frostfill
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr double kNever = std::numeric_limits<double>::max();

Pose poseFromJson(const Json& numbers)
{
    Pose pose;
    for (int i = 0; i < 9; ++i)
    {
        pose.rotation(i / 3, i % 3) = numbers.at(static_cast<std::size_t>(i)).get<double>();
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        pose.offset[axis] = numbers.at(9 + static_cast<std::size_t>(axis)).get<double>();
    }
    return pose;
}

} // namespace

Json poseToJson(const Pose& pose)
{
    Json numbers = Json::array();
    for (int i = 0; i < 9; ++i)
    {
        numbers.push_back(pose.rotation(i / 3, i % 3));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        numbers.push_back(pose.offset[axis]);
    }
    return numbers;
}

ColourFacts colourFacts(const Scene& scene, const Simulation& simulation)
{
    const auto spheres = static_cast<double>(simulation.expectedSpheres());
    const auto group = static_cast<double>(simulation.groupSize());
    return {std::max(1.0, std::ceil(spheres / group)),
            fallTime(scene, simulation.object()),
            {simulation.smallestRadius(), simulation.radius()}};
}

ColourRange colourRange(const Scene& scene, const ColourFacts& facts)
{
    const Column* column = findColumn(scene.style.colourBy);
    switch (column != nullptr ? column->scale : ColumnScale::own)
    {
    case ColumnScale::sets:
        return {0, std::max(1.0, std::ceil(facts.groups / scene.spheres.groupsPerSet) - 1)};
    case ColumnScale::groups:
        return {0, std::max(1.0, facts.groups - 1)};
    case ColumnScale::fall:
        return {0, scene.motion.gravity * facts.fallSeconds};
    case ColumnScale::radii:
        return facts.radii;
    default:
        return {}; // the renderer knows
    }
}

std::string headText(const RunHead& head)
{
    Json json;
    json["frostfill"] = head.version;
    if (!head.importedFrom.empty())
    {
        json["imported_from"] = head.importedFrom;
    }
    json["scene"] = sceneToJson(head.scene);
    json["repairs"] = head.repairs;
    if (head.lidTriangles > 0)
    {
        json["lid_triangles"] = head.lidTriangles;
    }
    for (const MeshPatch& patch : head.patches)
    {
        json["patches"].push_back({patch.name, patch.triangles});
    }
    json["video"] = head.video;
    json["groups"] = head.colours.groups;
    json["fall_seconds"] = head.colours.fallSeconds;
    json["radii"] = {head.colours.radii.low, head.colours.radii.high};
    json["frame_interval"] = head.interval < kNever ? Json(head.interval) : Json();
    json["stride"] = head.stride;
    json["poses"] = Json::array();
    for (const Pose& pose : head.poses)
    {
        json["poses"].push_back(poseToJson(pose));
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

RunHead readHead(const std::string& text, const std::string& nameForMessages)
{
    const auto refuse = [&]
    {
        return Error(ErrorCode::badData,
                     fmt::format("the head of '{}' is not that of a run of frostfill fill",
                                 nameForMessages));
    };
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains("scene"))
    {
        throw refuse();
    }
    try
    {
        RunHead head;
        head.version = json.at("frostfill").get<std::string>();
        head.importedFrom = json.value("imported_from", "");
        head.scene = sceneFromJson(json.at("scene"), nameForMessages);
        head.repairs = json.at("repairs").get<std::vector<std::string>>();
        head.lidTriangles = json.value("lid_triangles", std::size_t{0});
        for (const Json& patch : json.value("patches", Json::array()))
        {
            head.patches.push_back(
                {patch.at(0).get<std::string>(), patch.at(1).get<std::size_t>()});
        }
        head.video = json.at("video").get<std::string>();
        const auto radii = json.value("radii", std::array{0.0, 1.0}); // runs before 0.3 have none
        head.colours = {json.at("groups").get<double>(),
                        json.at("fall_seconds").get<double>(),
                        {radii[0], radii[1]}};
        const Json& interval = json.at("frame_interval");
        head.interval = interval.is_null() ? kNever : interval.get<double>();
        head.stride = std::max<std::size_t>(1, json.at("stride").get<std::size_t>());
        for (const Json& pose : json.at("poses"))
        {
            head.poses.push_back(poseFromJson(pose));
        }
        return head;
    }
    catch (const Json::exception&)
    {
        throw refuse();
    }
}

Scene loadRunScene(const std::filesystem::path& file)
{
    if (file.extension() != ".json")
    {
        return loadScene(file);
    }
    std::ifstream in(file);
    if (!in)
    {
        throw Error(ErrorCode::inputMissing, fmt::format("cannot read {}", file.string()));
    }
    const auto summary = nlohmann::ordered_json::parse(in, nullptr, false);
    if (!summary.is_object() || !summary.contains("scene"))
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{} is not the summary of a run", file.string()));
    }
    return sceneFromJson(summary["scene"], file.string());
}

Scene sceneOfRun(const RunFileReader& run)
{
    return readHead(run.head(), "run.frost").scene;
}

RenderSettings pictureSettings(const RunFileReader& run, const Scene& scene)
{
    const RunHead head = readHead(run.head(), "run.frost");
    return renderSettings(scene, colourRange(scene, head.colours), head.poses);
}

RenderSettings pictureSettings(const Simulation& simulation, const Scene& scene)
{
    return renderSettings(scene, colourRange(scene, colourFacts(scene, simulation)),
                          simulation.poses());
}

} // namespace frostfill

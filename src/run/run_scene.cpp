// SPDX-License-Identifier: MIT
#include "output/scene_json.hpp"
#include "run/frame_painter.hpp"
#include "run/run_head.hpp"

#include <frostfill/error.hpp>
#include <frostfill/fill.hpp>
#include <frostfill/picture_settings.hpp>

#include <fmt/format.h>

#include <fstream>

namespace frostfill
{

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

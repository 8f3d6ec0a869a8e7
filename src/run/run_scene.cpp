// SPDX-License-Identifier: MIT
#include "output/scene_json.hpp"

#include <frostfill/error.hpp>
#include <frostfill/fill.hpp>

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

} // namespace frostfill

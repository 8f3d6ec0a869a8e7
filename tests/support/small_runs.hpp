// SPDX-License-Identifier: MIT
#pragma once

#include "support/picture_files.hpp"

#include <frostfill/fill.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace frostfill::test
{

/// A run with small pictures in the directory.
inline FillRequest smallPictures(Scene scene, const std::filesystem::path& directory)
{
    FillRequest request;
    request.scene = std::move(scene);
    request.scene.size = {64, 48};
    request.scene.samples = 1;
    request.scene.style.legend = false;
    request.scene.threads = 1;
    request.directory = directory;
    return request;
}

/// [s] simulated, that a picture shows.
inline double timeOf(const std::filesystem::path& png)
{
    return std::stod(pictureText(png, "Time"));
}

inline std::string stateOf(const nlohmann::json& summary)
{
    return fmt::format(
        "{} running, {} frozen, {} discarded, {} polygons discarded",
        summary["spheres"]["running"].get<int>(), summary["spheres"]["frozen"].get<int>(),
        summary["spheres"]["discarded"].get<int>(), summary["polygons"]["discarded"].get<int>());
}

} // namespace frostfill::test

// SPDX-License-Identifier: MIT
#pragma once

#include "support/temporary_folder.hpp"

#include <frostfill/fill.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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

/// The text of a picture under a keyword; empty if there is none.
inline std::string pictureText(const std::filesystem::path& png, const std::string& keyword)
{
    const std::string bytes = readFile(png);
    const std::string chunk = "tEXt" + keyword + '\0';
    const std::size_t at = bytes.find(chunk);
    if (at == std::string::npos)
    {
        return "";
    }
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const std::size_t size = byte(at - 2) * std::size_t{256} + byte(at - 1);
    return bytes.substr(at + chunk.size(), size + 4 - chunk.size());
}

inline std::filesystem::path picture(const std::filesystem::path& directory, std::size_t index)
{
    return directory / "frames" / fmt::format("frame_{:05}.png", index);
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

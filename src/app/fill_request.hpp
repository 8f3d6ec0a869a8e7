// SPDX-License-Identifier: MIT
#pragma once

#include "app/progress/json_progress.hpp"
#include "app/scene_options.hpp"

#include <frostfill/fill.hpp>

#include <string>
#include <vector>

namespace frostfill
{

/// What the command line of `fill` gives.
struct FillArguments
{
    std::string mesh;
    std::string sceneFile;
    std::string directory;
    std::string resume;
    std::string video;
    std::string cameraPath;
    std::vector<std::string> exports; ///< formats
    bool contactSheet = false;
    bool overwrite = false;
    bool quiet = false;
    bool json = false;
    bool estimateVolume = false;
    bool view = false;
    bool fullMesh = false; ///< in the page and in exports
    bool dryRun = false;
    JsonProgress progress;
    GivenOptions given;
};

/// The scene that is asked for. Throws Error.
[[nodiscard]] Scene requestedScene(const FillArguments& arguments);

/// Without a MESH or a scene, the run that is resumed says all. Throws Error.
[[nodiscard]] FillRequest requestOf(const FillArguments& arguments);

/// Only for the command line: a scene file has the settings of both presets.
void warnOfIgnored(const FillArguments& arguments, Preset preset);

} // namespace frostfill

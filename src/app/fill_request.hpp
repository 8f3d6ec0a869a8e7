// SPDX-License-Identifier: MIT
#pragma once

#include "app/scene_options.hpp"

#include <frostfill/fill.hpp>

#include <string>

namespace frostfill
{

/// What the command line of `fill` gives.
struct FillArguments
{
    std::string mesh; ///< or a scene
    std::string out;
    std::string resume;
    std::string video;
    bool overwrite = false;
    bool quiet = false;
    bool json = false;
    bool dryRun = false;
    GivenOptions given;
};

/// A run to fill, and the files that are written beside it.
struct FillTask
{
    FillRequest request;
    std::filesystem::path page;    ///< empty for none
    std::filesystem::path picture; ///< of the only frame; empty for none
};

/// Without a MESH or a scene, the run that is resumed says all. Says what is implied and what has
/// no effect, unless quiet. Throws Error.
[[nodiscard]] FillTask taskOf(const FillArguments& arguments);

} // namespace frostfill

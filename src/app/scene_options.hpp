// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <CLI/App.hpp>

#include <map>
#include <string>

namespace frostfill
{

/// What was given on the command line, by the key of the option. Lives as long as the parser.
using GivenOptions = std::map<std::string, std::string>;

/// Adds every option of a scene to a command, grouped, with its default in the help.
void addSceneOptions(CLI::App& command, GivenOptions& given);

/// Sets what was given. Throws Error usage for a value that is not allowed.
void applyGivenOptions(const GivenOptions& given, Scene& scene);

/// One line that names what was given but is not used by this preset; empty when all of it is.
[[nodiscard]] std::string ignoredOptionsText(const GivenOptions& given, Preset preset);

} // namespace frostfill

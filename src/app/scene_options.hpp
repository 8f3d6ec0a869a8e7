// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/options.hpp>

#include <CLI/App.hpp>

#include <map>
#include <string>
#include <vector>

namespace frostfill
{

/// What was given on the command line for options, in the table's order. Must outlive the parser.
using GivenOptions = std::map<const Option*, std::string>;

/// Adds every option of a scene to a command, grouped, with its default in the help.
void addSceneOptions(CLI::App& command, GivenOptions& given);

/// Adds those of the pictures of a run that is over: all of frames, picture and camera but what
/// decides which states there are.
void addPictureOptions(CLI::App& command, GivenOptions& given);

/// Adds those that say how an open or broken mesh is made whole.
void addLoadOptions(CLI::App& command, GivenOptions& given);

/// The axis of the mesh that points up.
void addUpOption(CLI::App& command, GivenOptions& given);
/// Adds those that say what a mesh is in which spheres lie: the axis up, and how it is made whole.
void addCheckOptions(CLI::App& command, GivenOptions& given);

/// The program's arguments with the values of flags that may stand alone, and do.
[[nodiscard]] std::vector<std::string> withImpliedValues(int count, const char* const* arguments);

/// Sets the given options. Throws Error usage for a value that is not allowed.
void applyGivenOptions(const GivenOptions& given, Scene& scene);

/// One line with the given options that this preset does not use; empty if it uses all.
[[nodiscard]] std::string ignoredOptionsText(const GivenOptions& given, Preset preset);

} // namespace frostfill

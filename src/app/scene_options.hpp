// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/options.hpp>

#include <CLI/App.hpp>

#include <map>
#include <string>

namespace frostfill
{

/// The value of an option on the command line.
struct GivenOption
{
    std::string name; ///< as it was called: its flag, or its key
    std::string text;
};

/// In the table's order. Must outlive the parser.
using GivenOptions = std::map<const Option*, GivenOption>;

/// Adds the argument that names a mesh, or several files that are its patches.
CLI::Option* addMeshArgument(CLI::App& command, const char* name, std::string& mesh,
                             const std::string& help);

/// Adds the flags of the scene's options that the command takes, with their defaults in the help,
/// and --set, which takes each of them by its key.
void addSceneOptions(CLI::App& command, GivenOptions& given);

/// A line for each key that the command takes; empty for a command without a scene.
[[nodiscard]] std::string sceneKeysText(const CLI::App& command);

/// Sets the given options. Throws Error usage for a value that is not allowed.
void applyGivenOptions(const GivenOptions& given, Scene& scene);

/// One line with the given options that this preset does not use; empty if it uses all.
[[nodiscard]] std::string ignoredOptionsText(const GivenOptions& given, Preset preset);

} // namespace frostfill

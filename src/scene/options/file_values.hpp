// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/options.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// A value of a TOML file, and where it stands.
struct FileValue
{
    OptionValue value;
    std::uint32_t line = 0;
    bool readable = true;        ///< of a type that an option can have
    std::vector<FileValue> list; ///< of an array, its elements
};

/// By the whole key, such as "spheres.radius".
using FileValues = std::map<std::string, FileValue>;

/// Throws Error badData with the line.
[[nodiscard]] FileValues readTomlValues(std::string_view toml, std::string_view nameForMessages);

/// The scene with these values; what they lack is as in the preset. Throws Error badData.
[[nodiscard]] Scene sceneFromValues(const FileValues& values, std::string_view nameForMessages);

/// Throws Error inputMissing.
[[nodiscard]] std::string readSceneFile(const std::filesystem::path& file);

/// Files that the scene names are relative to the folder of the file that has the scene.
void resolvePaths(Scene& scene, const std::filesystem::path& folder);

} // namespace frostfill

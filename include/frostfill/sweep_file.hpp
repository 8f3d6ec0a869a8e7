// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// One run of a sweep.
struct SweepRun
{
    /// "mesh=torus,radius=0.05,seed=3": its folder. It follows from the swept values alone, so that
    /// a run keeps it when others are added.
    std::string name;
    Scene scene;
    /// Keys of scene files and their values as on the command line, in the order of
    /// docs/options.md.
    std::vector<std::pair<std::string, std::string>> swept;
};

/// Reads a sweep: a table [scene] like a scene file, and a table [sweep] in which keys of scenes
/// have lists of values. There is a run for each combination, in the order of docs/options.md: the
/// first key varies slowest, the last fastest. Mesh paths are relative to the file. Throws Error
/// inputMissing, or badData with the line.
[[nodiscard]] std::vector<SweepRun> loadSweep(const std::filesystem::path& file);
[[nodiscard]] std::vector<SweepRun> parseSweep(std::string_view toml,
                                               std::string_view nameForMessages);

} // namespace frostfill
#pragma GCC visibility pop

// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/sweep.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace frostfill
{

/// Reads meshes to know runs by their hashes. Runs of one mesh that follow one another read it
/// once.
class RunHashes
{
public:
    /// Throws Error for a mesh that cannot be used.
    [[nodiscard]] std::string of(const Scene& scene);

private:
    std::string known_;
    TriangleMesh mesh_;
};

/// Whether the folder holds this run, ended, with all files that its summary lists.
[[nodiscard]] bool isComplete(const Scene& scene, const std::string& runHash,
                              const std::filesystem::path& folder);

/// What a folder holds in place of a complete run.
enum class FolderContent
{
    nothing,   ///< or what is not worth keeping
    resumable, ///< this run, which can be resumed
    partial,   ///< this run, without a file to resume it from
    other,     ///< another run
};
[[nodiscard]] FolderContent contentOf(const Scene& scene, const std::string& runHash,
                                      const std::filesystem::path& folder);

/// What is known of a run from its folder.
[[nodiscard]] RunReport lookAt(const Scene& scene, const std::string& runHash,
                               const std::filesystem::path& folder);

} // namespace frostfill

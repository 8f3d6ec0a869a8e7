// SPDX-License-Identifier: MIT
// Room: a kept run as one HTML page that any browser shows. It reads the run file and simulates
// nothing.
#pragma once

#include <frostfill/shell.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>

#pragma GCC visibility push(default)
namespace frostfill
{

/// The page's name in the directory of a run.
inline constexpr const char* kPageFile = "view.html";

struct PageRequest
{
    std::filesystem::path run;  ///< a run file, or a folder that has run.frost
    std::filesystem::path file; ///< to write; empty: view.html beside the run file
    /// Motion that would make the page larger than this is left away. [byte]
    std::uint64_t maxBytes = 40'000'000;
    bool overwrite = false; ///< an earlier page
    bool fullMesh = false;  ///< all triangles of a dense mesh, in place of a simplified shell
};

struct PageResult
{
    std::filesystem::path file;
    std::uint64_t bytes = 0;       ///< of the page
    std::uint64_t motionBytes = 0; ///< that it would have with motion, if that was left away; or 0
    std::size_t frames = 0;        ///< in the page
    std::size_t keptFrames = 0;    ///< in the run file
    std::size_t spheres = 0;       ///< in the last frame
    double error = 0;              ///< of each coordinate of a centre, at most [mesh unit]
    double errorOverRadius = 0;    ///< the same [smallest radius]
    ShellInFile shell;
    bool ended = false; ///< the run, when the file was read
};

/// Called after each frame with the number that are done and all; false stops.
using PageProgress = std::function<bool(std::size_t done, std::size_t all)>;

/// Writes a page that shows a run: the filling from all sides and at all times, its counts, sets,
/// errors and machine. The page needs nothing but itself; docs/view.md tells what is in it. The
/// same run file, with the same sets.csv beside it, gives the same bytes. Throws Error inputMissing
/// or badData for a run that cannot be read, usage if not even the last frame fits into maxBytes,
/// cannotCreate if the file is there already, writeFailed, and stoppedEarly.
PageResult writePage(const PageRequest& request, const PageProgress& progress = {});

} // namespace frostfill
#pragma GCC visibility pop

// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/error.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/shard.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// A run that was kept, to be drawn again, and how.
struct RenderRequest
{
    std::filesystem::path run;       ///< its directory or its run.frost
    std::filesystem::path directory; ///< for the pictures; empty: "render" in the run's
    /// Changes frames, picture and camera of the run's scene. Empty: all as in the run.
    std::function<void(Scene&)> change;
    bool overwrite = false; ///< replace what the directory holds
    /// Leave pictures as they are that are whole and say of themselves what would be drawn.
    bool skipExisting = false;
    /// Draw only the pictures of this part; other processes draw the others, into the same
    /// directory. Pictures that are there are left as with skipExisting. Not with a video.
    Shard shard;
    /// Draw nothing: look whether all pictures are there.
    bool gather = false;
    /// Check everything that can be checked, and count the pictures; write nothing.
    bool dryRun = false;
    std::filesystem::path video; ///< .mp4, .webm, .gif, or "-": standard output; or empty
};

/// What the caller wants to hear. Every function may be empty.
struct RenderObserver
{
    std::function<void(std::size_t done, std::size_t all)> progressed; ///< frames
    std::function<bool()> stopRequested;                               ///< asked before every frame
};

struct RenderResult
{
    std::filesystem::path directory;
    std::size_t frames = 0;        ///< pictures
    std::size_t skippedFrames = 0; ///< of them, that were there already
    std::size_t allFrames = 0;     ///< pictures of all parts together
    /// When gathering: pictures that are not there, or are not what would be drawn.
    std::vector<std::size_t> missing;
    std::size_t surplus = 0;                 ///< pictures in the directory that are none of these
    std::size_t keptFrames = 0;              ///< frames in the run file
    bool ended = false;                      ///< the run, when the file was read
    std::uint64_t wholeBytes = 0;            ///< of the run file
    std::uint64_t fileBytes = 0;             ///< more than that if its end is torn
    bool stopped = false;                    ///< by stopRequested
    bool blank = false;                      ///< some picture shows nothing
    std::optional<std::string> videoFailure; ///< in a sentence; the pictures are all there
    std::string renderer;
    double wallSeconds = 0;
};

/// Does what `frostfill render` does: draws a kept run again. A picture depends on the run, the
/// settings and the number of its frame alone; with the settings of the run it has the bytes of the
/// picture that `fill` drew. Throws Error; see ErrorCode.
[[nodiscard]] RenderResult renderRun(const RenderRequest& request,
                                     const RenderObserver& observer = {});

/// What went wrong with pictures that are written all the same, and where they are; none if nothing
/// did.
[[nodiscard]] std::optional<Error> failureOf(const RenderResult& result);

} // namespace frostfill
#pragma GCC visibility pop

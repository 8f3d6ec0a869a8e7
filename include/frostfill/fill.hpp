// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/error.hpp>
#include <frostfill/scene.hpp>
#include <frostfill/simulation.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#pragma GCC visibility push(default)
namespace frostfill
{

/// What to fill, and where the files of the run go.
struct FillRequest
{
    Scene scene; ///< with the mesh, by file or by name
    /// A mesh in memory in place of that of the scene, whose name then stands only in messages and
    /// in the files of the run. It is repaired like one that is read.
    std::optional<TriangleMesh> mesh = {};
    std::filesystem::path directory;
    bool overwrite = false; ///< replace the run that the directory holds
    /// Go on with the run that the directory holds, begun with the same scene by the same version.
    /// It is simulated again from its start; pictures that are there are not drawn again. Without a
    /// run in the directory it is begun.
    bool resume = false;
    std::filesystem::path video; ///< .mp4, .webm, .gif, or "-": standard output; or empty
};

/// What is known before the first step.
struct FillPlan
{
    std::vector<std::string> repairs; ///< of the mesh
    std::vector<std::string> hints;   ///< sentences on options that the mesh may need
    std::size_t triangles = 0;
    std::size_t crossedTriangles = 0; ///< that meet others away from their edges
    Eigen::Vector3d firstCrossing = Eigen::Vector3d::Zero(); ///< if there are any
    std::size_t spheres = 0;
    double smallestRadius = 0; ///< [mesh unit]
    double largestRadius = 0;  ///< [mesh unit]
    double timeStep = 0;       ///< [s]
    double slowMotion = 1;     ///< [1] time in a video over simulated time; 0 when nothing moves
    double videoSeconds = 0;   ///< [s] of video, of all frames
    double pictureRate = 0;    ///< pictures per second with which they play like the video
    double fallSeconds = 0;    ///< [s] of video, of a fall through the object as it is drawn
    bool fallsLeftOut =
        false;              ///< spheres appear where they land: there are too many for a trial run
    std::size_t frames = 0; ///< pictures to expect: within a tenth, as there was a trial run
    double frameBytes = 0;  ///< of all pictures: a rough estimate
    double volume = 0;      ///< [unit^3] of the object
    ReachInspection reach;  ///< of the smallest radius
};

/// How far a run is.
struct FillProgress
{
    std::size_t spheres = 0; ///< that have appeared
    std::size_t resting = 0;
    std::size_t expected = 0;
    std::size_t frames = 0;
    double time = 0; ///< [s] simulated; of the pictures, if the run is over
    /// To expect. 0 while the run is simulated, and otherwise it is over and its pictures are made.
    std::size_t pictures = 0;
    bool settles = false; ///< all spheres settle together: see Simulation::settles
};

/// What the caller wants to hear. Every function may be empty.
struct FillObserver
{
    std::function<void()> loaded; ///< the mesh is read, and nothing is written yet
    std::function<void(const FillPlan&)> planned;
    std::function<void(const FillProgress&)> progressed; ///< after every step
    /// Asked after every step, and within long searches. Once true, it stays true.
    std::function<bool()> stopRequested;
};

/// What drawing took while a set was the newest; one entry a frame. [ms]
struct SetFrames
{
    std::vector<double> renderMs;
    std::vector<double> readbackMs;
    std::vector<double> encodeMs; ///< and writing
};

/// What a run has come to. The files in the directory hold more; see `frostfill fill`.
struct FillResult
{
    std::filesystem::path directory;
    std::vector<SetRecord> sets;
    std::vector<SetFrames> setFrames; ///< by the index of the set; empty when nothing was drawn
    std::size_t frames = 0;
    std::size_t skippedFrames = 0; ///< of them, that were there already
    std::size_t spheres = 0;
    std::size_t wanted = 0; ///< spheres that the run aimed at
    /// Equal spheres that would fill the object, within a few per cent; 0 for different radii.
    std::size_t fitting = 0;
    double smallestRadius = 0; ///< [mesh unit]
    double largestRadius = 0;  ///< [mesh unit]
    bool full = false;
    bool inletsReached = false; ///< no sphere comes through the inlets any more
    bool stopped = false;       ///< by stopRequested
    /// A run until full was stopped because its spheres take more than the object's volume.
    bool overfull = false;
    /// [mesh unit] With which the spheres asked for are expected to fit, the largest of several; if
    /// the object was full before.
    std::optional<double> radiusThatFits;
    double wallSeconds = 0; ///< of the whole run but the writing of its last files
    /// What these seconds went into, one part of the run after the other. The times of stages are
    /// apart from that: several go on at once.
    std::vector<std::pair<std::string, double>> phases;
    std::string renderer; ///< empty when nothing was drawn
    std::string stateHash;
    std::string summary; ///< the text of summary.json
    QualityReport quality;
    /// That no picture was drawn, although some were asked for, in a sentence.
    std::optional<std::string> noFrames;
    /// What went wrong with the video, in a sentence; all other files are there.
    std::optional<std::string> videoFailure;
    ReachInspection reach;            ///< of the smallest radius, in the empty object
    std::optional<SizeReport> sizes;  ///< of a scene with a size curve
    std::optional<StraySphere> stray; ///< for which the run was stopped
    /// A postcondition that failed, in a sentence; the files are written all the same.
    std::optional<std::string> failure;
};

/// Does what `frostfill fill` does: loads the mesh, fills it, draws frames and writes every file of
/// a run into the directory. Throws Error; see ErrorCode.
[[nodiscard]] FillResult fill(const FillRequest& request, const FillObserver& observer = {});

/// What went wrong with a run whose files are written all the same, and where they are; none if
/// nothing did.
[[nodiscard]] std::optional<Error> failureOf(const FillResult& result);

/// The request with which the run in a directory was begun, to resume it. Throws Error
/// inputMissing if none was kept there, or badData.
[[nodiscard]] FillRequest resumeRequest(const std::filesystem::path& directory);

/// How the run in a directory has ended, as in summary.json: "full", "inlets reached", "count
/// reached", "stopped" or "failed"; empty if it has not.
[[nodiscard]] std::string outcomeOfRun(const std::filesystem::path& directory);

/// Reads the scene of a run: from a scene file (TOML), or from the summary.json of a run to repeat.
/// Throws Error inputMissing or badData.
[[nodiscard]] Scene loadRunScene(const std::filesystem::path& file);

/// The table with which `frostfill fill` ends: frames a second, and milliseconds a frame for each
/// stage. A row a set and one for all; sets share rows when there are more than `mostRows`. Empty
/// without sets.
[[nodiscard]] std::string setTableText(const FillResult& result, std::size_t mostRows = 24);

} // namespace frostfill
#pragma GCC visibility pop

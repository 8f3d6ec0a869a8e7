// SPDX-License-Identifier: MIT
// Room: what the commands fill and render do: plan, run, record and paint frames, write the files.
// It joins simulation and renderer, which do not know each other.
#pragma once

#include "run/frame_timing.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/mesh.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace frostfill
{

/// All that the files of a run are made from.
struct RunRecord
{
    const FillRequest& request;
    const LoadedMesh& mesh;
    const Simulation& simulation;
    const FramePlan& frames;
    const FillResult& result;
    StageTimes times;       ///< of simulation and pictures together
    std::size_t stride = 1; ///< every stride-th of the selected frames was kept
};

/// What the judge says of any packing, by the names of summary.json. What was not judged is left
/// out, and a number that is infinite is null.
[[nodiscard]] nlohmann::ordered_json qualityJson(const QualityReport& quality);

/// The text of summary.json.
[[nodiscard]] std::string summaryText(const RunRecord& run);

/// Writes every file but the frames. Throws Error cannotCreate or writeFailed.
void writeRunFiles(const RunRecord& run);

/// Names and versions of the libraries that this program was built with.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> libraryVersions();

/// The computer, the build, the libraries and the renderer, as files tell them. `renderer` is empty
/// when nothing was drawn.
[[nodiscard]] nlohmann::ordered_json machineJson(const std::string& renderer);

/// Overlap of two spheres, or of a sphere with a wall, with which a run of preset fast has failed
/// [own radius]. Ours are rounding, 1e-7 at most, so this much is a fault.
inline constexpr double kFaultyOverlap = 1e-6;
/// The most that the packing fraction of the bulk may differ from one that is asked for [1].
inline constexpr double kFaultyFraction = 0.002;
/// Share of the spheres that may hang in the air at the end of a run of preset fast [1]. One sphere
/// may in any run.
inline constexpr double kFaultyHanging = 0.005;

/// What is wrong with the end of a run and what may help, in a sentence; none if nothing is. The
/// paper's preset leaves overlaps and spheres in the air by its nature, so there only numbers and
/// sides are judged. A run that was stopped, or with restitution 1, is not judged for support.
[[nodiscard]] std::optional<std::string> findFault(const Scene& scene, const FillResult& result,
                                                   bool blankPictures);

} // namespace frostfill

// SPDX-License-Identifier: MIT
// Room: what the commands fill and render do: plan, run, record and paint frames, write the files.
// It joins simulation and renderer, which do not know each other.
#pragma once

#include "run/frame_timing.hpp"

#include <frostfill/fill.hpp>
#include <frostfill/mesh.hpp>

#include <nlohmann/json.hpp>

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

} // namespace frostfill

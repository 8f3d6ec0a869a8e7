// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/fill.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace frostfill
{

/// The time of one set, split by what it was spent on. [ms a frame; a step when none is drawn]
struct SetTiming
{
    std::string name; ///< the set's index, "4-11" for several, "all"
    std::size_t spheres = 0;
    std::size_t frames = 0;
    std::uint64_t steps = 0;
    double framesPerSecond = 0;
    double sphereSphereMs = 0;
    double spherePolygonMs = 0;
    double freezingMs = 0;
    double discardingMs = 0;
    double otherMs = 0; ///< motion and the search for free places
    double renderMs = 0;
    double readbackMs = 0;
    double encodeMs = 0;
    std::size_t running = 0; ///< at the end
    std::size_t frozen = 0;
    std::size_t discarded = 0;
};

/// A row a set; with more than `limit` sets neighbours share rows so that there are at most so
/// many. The last row is for all of them. Empty without sets.
[[nodiscard]] std::vector<SetTiming> setTable(std::span<const SetRecord> sets,
                                              std::span<const SetFrames> frames, std::size_t limit);

/// The rows as text, with headings.
[[nodiscard]] std::string formatSetTable(std::span<const SetTiming> rows);

/// sets.csv: a row a set, every column. Throws Error cannotCreate or writeFailed.
void writeSetsCsv(std::span<const SetRecord> sets, std::span<const SetFrames> frames,
                  const std::filesystem::path& file);

} // namespace frostfill

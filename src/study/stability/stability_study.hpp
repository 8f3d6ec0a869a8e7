// SPDX-License-Identifier: MIT
// Room: a matrix of extreme scenes, each with a verdict. It shows where a method breaks.
#pragma once

#include "study/stability/stress_matrix.hpp"
#include "study/table.hpp"

#include <functional>
#include <string>
#include <vector>

namespace frostfill
{

/// How far a study is, for a progress bar: parts done, parts in all, and what has just ended.
using StudyProgress = std::function<void(std::size_t, std::size_t, const std::string&)>;

/// A cell of the matrix with what came out.
struct StabilityResult
{
    std::string method;
    Preset preset = Preset::fast;
    std::string axis;
    std::string label;
    Expectation expected = Expectation::passes;
    StressOutcome outcome;

    /// Whether a sound method does what this one did.
    [[nodiscard]] bool sound() const;
};

/// Runs the whole matrix, each cell twice, on all cores.
[[nodiscard]] std::vector<StabilityResult> measureStability(bool quick,
                                                            const StudyProgress& progress);

/// Every cell with all its numbers; `row` and `column` say where the heat map has it.
[[nodiscard]] Table stabilityCsv(const std::vector<StabilityResult>& results);
/// How often each verdict was given, by method.
[[nodiscard]] Table stabilityTable(const std::vector<StabilityResult>& results);
/// The cells that are not sound, of one preset.
[[nodiscard]] Table unsoundTable(const std::vector<StabilityResult>& results, Preset preset);

} // namespace frostfill

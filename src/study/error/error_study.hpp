// SPDX-License-Identifier: MIT
// Room: errors against closed forms, and run time against error. Each point is one run that was
// judged.
#pragma once

#include "study/stability/stability_study.hpp"
#include "study/table.hpp"

#include <string>
#include <vector>

namespace frostfill
{

/// One run: what it cost and how wrong it was.
struct ErrorPoint
{
    std::string study;   ///< the curve's figure: "steps", "discards", "volume", "layers", "rest",
                         ///< "rendering"
    std::string curve;   ///< the method
    std::string setting; ///< what is varied, and its value
    bool isDefault = false;
    double seconds = 0; ///< of processor time, one thread
    double error = 0;   ///< what the figure shows; see errorMeaning
    /// More numbers of the same run, named by detailNames.
    std::vector<double> details;
    bool onFront = false; ///< no rival is both faster and better
    std::string rivals;   ///< a point competes with those of its study that have the same here
};

/// What `error` is in a study, and the names of its details.
struct ErrorStudyInfo
{
    const char* name;
    const char* error;
    std::vector<const char*> details;
};
[[nodiscard]] const std::vector<ErrorStudyInfo>& errorStudies();

/// All runs of the studies. Pareto fronts are marked, study by study. `objects`: mesh files to be
/// filled for the study of volumes, beside the four that are built in.
[[nodiscard]] std::vector<ErrorPoint>
measureErrors(bool quick, const std::vector<std::string>& objects, const StudyProgress& progress);

/// Errors below this are none: what is left is rounding.
inline constexpr double kNoError = 1e-9;
/// Times that differ by less than this share are the same: they scatter as much.
inline constexpr double kSameTime = 0.05;

/// Marks the points for which no rival is at least as good in both ways and better in one.
void markFront(std::vector<ErrorPoint>& points, const std::string& study);

[[nodiscard]] Table errorCsv(const std::vector<ErrorPoint>& points, const ErrorStudyInfo& study);
[[nodiscard]] Table errorTable(const std::vector<ErrorPoint>& points, const ErrorStudyInfo& study);

} // namespace frostfill

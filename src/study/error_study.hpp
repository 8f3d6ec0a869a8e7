// SPDX-License-Identifier: MIT
#pragma once

#include "study/stability_study.hpp"
#include "study/table.hpp"

#include <string>
#include <vector>

namespace frostfill
{

/// One run: what it cost and how wrong it was.
struct ErrorPoint
{
    std::string study;   ///< the curve's figure: "steps", "discards", "volume", "layers"
    std::string curve;   ///< the method
    std::string setting; ///< what is varied, and its value
    bool isDefault = false;
    double seconds = 0; ///< of processor time, one thread
    double error = 0;   ///< what the figure shows; see errorMeaning
    /// More numbers of the same run, named by detailNames.
    std::vector<double> details;
    bool onFront = false; ///< no other point of the study is both faster and better
};

/// What `error` is in a study, and the names of its details.
struct ErrorStudyInfo
{
    const char* name;
    const char* error;
    std::vector<const char*> details;
};
[[nodiscard]] const std::vector<ErrorStudyInfo>& errorStudies();

/// All runs of the studies. Pareto fronts are marked, study by study.
[[nodiscard]] std::vector<ErrorPoint> measureErrors(bool quick, const StudyProgress& progress);

/// Marks the points for which no other is at least as good in both ways and better in one.
void markFront(std::vector<ErrorPoint>& points, const std::string& study);

[[nodiscard]] Table errorCsv(const std::vector<ErrorPoint>& points, const ErrorStudyInfo& study);
[[nodiscard]] Table errorTable(const std::vector<ErrorPoint>& points, const ErrorStudyInfo& study);

} // namespace frostfill

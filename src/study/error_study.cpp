// SPDX-License-Identifier: MIT
#include "study/error_study.hpp"

#include "study/error_runs.hpp"

#include <fmt/format.h>

#include <cmath>

namespace frostfill
{

const std::vector<ErrorStudyInfo>& errorStudies()
{
    static const std::vector<ErrorStudyInfo> kStudies = {
        {"steps",
         "largest overlap [r] + unsupported share",
         {"max_overlap", "mean_overlap", "max_overlap_running", "unsupported_share", "energy_gain",
          "energy_excess", "outside"}},
        {"discards",
         "farthest deviation from the run without [r]",
         {"spheres_dropped", "polygons_dropped", "seconds_without", "outside", "max_overlap"}},
        {"volume",
         "error of the wall-corrected volume",
         {"rS_over_V", "spheres", "raw_error", "corrected_error", "fraction", "sphere_volume",
          "volume"}},
        {"layers",
         "random close packing less packing fraction",
         {"layers", "fraction", "contacts", "spheres_counted", "unsupported_share"}},
    };
    return kStudies;
}

void markFront(std::vector<ErrorPoint>& points, const std::string& study)
{
    for (ErrorPoint& point : points)
    {
        if (point.study != study)
            continue;
        point.onFront = std::isfinite(point.error);
        for (const ErrorPoint& other : points)
            if (other.study == study && other.seconds <= point.seconds &&
                other.error <= point.error &&
                (other.seconds < point.seconds || other.error < point.error))
                point.onFront = false;
    }
}

std::vector<ErrorPoint> measureErrors(bool quick, const StudyProgress& progress)
{
    std::vector<ErrorTask> tasks;
    addStepRuns(tasks, quick);
    addDiscardRuns(tasks, quick);
    addVolumeRuns(tasks, quick);
    addLayerRuns(tasks, quick);
    std::vector<ErrorPoint> points;
    for (const ErrorTask& task : tasks)
    {
        points.push_back(task()); // one after another: their times count
        progress(points.size(), tasks.size(),
                 fmt::format("{}: {}, {}", points.back().study, points.back().curve,
                             points.back().setting));
    }
    for (const ErrorStudyInfo& study : errorStudies())
        markFront(points, study.name);
    return points;
}

Table errorCsv(const std::vector<ErrorPoint>& points, const ErrorStudyInfo& study)
{
    Table table;
    table.headings = {"curve", "setting", "seconds", "error", "default", "front"};
    table.headings.insert(table.headings.end(), study.details.begin(), study.details.end());
    for (const ErrorPoint& point : points)
    {
        if (point.study != study.name)
            continue;
        std::vector<std::string> row = {point.curve,
                                        point.setting,
                                        fmt::format("{:.4f}", point.seconds),
                                        fmt::format("{:.4e}", point.error),
                                        point.isDefault ? "1" : "0",
                                        point.onFront ? "1" : "0"};
        for (const double detail : point.details)
            row.push_back(fmt::format("{:.6g}", detail));
        table.rows.push_back(row);
    }
    return table;
}

Table errorTable(const std::vector<ErrorPoint>& points, const ErrorStudyInfo& study)
{
    Table table;
    table.title =
        fmt::format("{}: time against {} (* on the Pareto front)", study.name, study.error);
    table.words = 2;
    table.headings = {"method", "setting", "seconds", "error", "front"};
    for (const ErrorPoint& point : points)
        if (point.study == study.name)
            table.rows.push_back({point.curve,
                                  point.setting + (point.isDefault ? " (default)" : ""),
                                  fmt::format("{:.3f}", point.seconds),
                                  fmt::format("{:.2e}", point.error), point.onFront ? "*" : ""});
    return table;
}

} // namespace frostfill

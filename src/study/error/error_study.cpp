// SPDX-License-Identifier: MIT
#include "study/error/error_study.hpp"

#include "study/error/error_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{

const std::vector<ErrorStudyInfo>& errorStudies()
{
    static const std::vector<ErrorStudyInfo> kStudies = {
        {"steps",
         "overlap while moving [r] + unsupported share",
         {"step", "sweeps", "moving_overlap", "mean_moving_overlap", "max_overlap", "mean_overlap",
          "unsupported_share", "energy_gain", "energy_excess", "outside"}},
        {"discards",
         "farthest deviation from the run without [r]",
         {"spheres_dropped", "polygons_dropped", "seconds_without", "outside", "max_overlap"}},
        {"volume", "error of the volume", {"rS_over_V", "spheres", "signed_error", "fraction"}},
        {"layers",
         "random close packing less packing fraction",
         {"layers", "fraction", "contacts", "spheres_counted", "max_overlap", "overdue",
          "unsupported_share"}},
        {"rest",
         "share of spheres unbalanced by more than a tenth of their weight",
         {"friction", "least_friction", "largest_unbalance", "max_overlap", "spheres", "rests"}},
        {"rendering",
         "difference from a picture of 256 samples a pixel [of 255, root mean square]",
         {"samples", "supersample", "triangles", "largest", "pixels_apart"}},
    };
    return kStudies;
}

void markFront(std::vector<ErrorPoint>& points, const std::string& study)
{
    const auto wrong = [](const ErrorPoint& point) { return std::max(point.error, kNoError); };
    const auto beats = [&](const ErrorPoint& a, const ErrorPoint& b)
    {
        const bool faster = a.seconds < (1 - kSameTime) * b.seconds;
        return (faster && wrong(a) <= wrong(b)) || (a.seconds <= b.seconds && wrong(a) < wrong(b));
    };
    for (ErrorPoint& point : points)
    {
        if (point.study == study)
        {
            point.onFront = std::isfinite(point.error) &&
                            std::none_of(points.begin(), points.end(),
                                         [&](const ErrorPoint& other) {
                                             return other.study == study &&
                                                    other.rivals == point.rivals &&
                                                    beats(other, point);
                                         });
        }
    }
}

std::vector<ErrorPoint> measureErrors(bool quick, const std::vector<std::string>& objects,
                                      const StudyProgress& progress)
{
    std::vector<ErrorTask> tasks;
    addStepRuns(tasks, quick);
    addDiscardRuns(tasks, quick);
    addVolumeRuns(tasks, objects, quick);
    addLayerRuns(tasks, quick);
    addRestRuns(tasks, quick);
    addRenderRuns(tasks, quick);
    addShellRuns(tasks, quick);
    std::vector<ErrorPoint> points;
    for (const ErrorTask& task : tasks)
    {
        points.push_back(task()); // one after another: their times count
        progress(points.size(), tasks.size(),
                 fmt::format("{}: {}, {}", points.back().study, points.back().curve,
                             points.back().setting));
    }
    for (const ErrorStudyInfo& study : errorStudies())
    {
        markFront(points, study.name);
    }
    return points;
}

Table errorCsv(const std::vector<ErrorPoint>& points, const ErrorStudyInfo& study)
{
    Table table;
    table.headings = {"curve", "setting", "rivals", "seconds", "error", "default", "front"};
    table.headings.insert(table.headings.end(), study.details.begin(), study.details.end());
    for (const ErrorPoint& point : points)
    {
        if (point.study != study.name)
        {
            continue;
        }
        std::vector<std::string> row = {point.curve,
                                        point.setting,
                                        point.rivals,
                                        fmt::format("{:.4f}", point.seconds),
                                        fmt::format("{:.4e}", point.error),
                                        point.isDefault ? "1" : "0",
                                        point.onFront ? "1" : "0"};
        for (const double detail : point.details)
        {
            row.push_back(fmt::format("{:.6g}", detail));
        }
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
    {
        if (point.study == study.name)
        {
            table.rows.push_back({point.curve,
                                  point.setting + (point.isDefault ? " (default)" : ""),
                                  fmt::format("{:.3f}", point.seconds),
                                  fmt::format("{:.2e}", point.error), point.onFront ? "*" : ""});
        }
    }
    return table;
}

} // namespace frostfill

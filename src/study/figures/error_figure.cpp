// SPDX-License-Identifier: MIT
#include "study/error/error_study.hpp"
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

std::string fileOf(const ErrorStudyInfo& study)
{
    return fmt::format("error-{}.csv", study.name);
}

void makeErrorData(const FigureFolder& folder)
{
    const auto recorded = [&](const ErrorStudyInfo& study) { return folder.reuse(fileOf(study)); };
    if (std::all_of(errorStudies().begin(), errorStudies().end(), recorded))
    {
        return;
    }
    const auto progress = [&](std::size_t done, std::size_t all, const std::string& what)
    { folder.progress(done, all, what); };
    const std::vector<ErrorPoint> points = measureErrors(folder.quick(), {}, progress);
    for (const ErrorStudyInfo& study : errorStudies())
    {
        folder.write(fileOf(study), errorCsv(points, study));
    }
}

} // namespace

Figure errorFigure()
{
    return {"error", "run time against error", true, 350, makeErrorData, embedded::figure_error};
}

} // namespace frostfill

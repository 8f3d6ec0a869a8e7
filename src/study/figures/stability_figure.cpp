// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/stability/stability_study.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

void makeStabilityData(const FigureFolder& folder)
{
    // A matter of minutes, so it is taken from the record like measured times.
    if (folder.reuse("stability.csv"))
    {
        return;
    }
    const auto progress = [&](std::size_t done, std::size_t all, const std::string& what)
    { folder.progress(done, all, what); };
    folder.write("stability.csv", stabilityCsv(measureStability(folder.quick(), progress)));
}

} // namespace

Figure stabilityFigure()
{
    return {"stability",
            "the stress matrix: where which method breaks",
            true,
            200,
            makeStabilityData,
            embedded::figure_stability};
}

} // namespace frostfill

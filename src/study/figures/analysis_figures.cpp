// SPDX-License-Identifier: MIT
#include "study/figures/analysis_figures.hpp"

#include "base/atomic_file.hpp"
#include "study/figures/embedded_scripts.hpp"

#include <algorithm>
#include <string_view>

namespace frostfill
{
namespace
{

struct AnalysisFigure
{
    const char* table; ///< that it is drawn from
    const char* script;
    std::string_view (*text)();
};

constexpr AnalysisFigure kFigures[] = {
    {"porosity_height.csv", "porosity.gp", embedded::figure_analysis_porosity},
    {"pairs.csv", "pairs.gp", embedded::figure_analysis_pairs},
    {"contacts.csv", "contacts.gp", embedded::figure_analysis_contacts},
    {"cells.csv", "cells.gp", embedded::figure_analysis_cells},
    {"order.csv", "order.gp", embedded::figure_analysis_order},
    {"sizes_height.csv", "sizes.gp", embedded::figure_analysis_sizes},
};

void write(const std::filesystem::path& file, std::string_view text)
{
    AtomicFile out(file);
    out.write(text);
    out.commit();
}

} // namespace

void drawAnalysis(const std::filesystem::path& folder, const std::vector<std::string>& names)
{
    write(folder / "style.gp", embedded::figure_style());
    for (const AnalysisFigure& figure : kFigures)
    {
        if (std::find(names.begin(), names.end(), figure.table) == names.end())
        {
            continue;
        }
        write(folder / figure.script, figure.text());
        for (const char* format : {"svg", "png"})
        {
            runGnuplot(folder, figure.script, format);
        }
    }
}

} // namespace frostfill

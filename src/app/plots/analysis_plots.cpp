// SPDX-License-Identifier: MIT
#include "app/plots/analysis_plots.hpp"

#include "app/plots/embedded_scripts.hpp"
#include "base/atomic_file.hpp"
#include "base/run_program.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

namespace frostfill
{
namespace
{

struct AnalysisPlot
{
    const char* table; ///< that it is drawn from
    const char* script;
    std::string_view (*text)();
};

constexpr AnalysisPlot kPlots[] = {
    {"porosity_height.csv", "porosity.gp", embedded::plot_analysis_porosity},
    {"pairs.csv", "pairs.gp", embedded::plot_analysis_pairs},
    {"contacts.csv", "contacts.gp", embedded::plot_analysis_contacts},
    {"cells.csv", "cells.gp", embedded::plot_analysis_cells},
    {"order.csv", "order.gp", embedded::plot_analysis_order},
    {"sizes_height.csv", "sizes.gp", embedded::plot_analysis_sizes},
};

void writeScript(const std::filesystem::path& file, std::string_view text)
{
    AtomicFile out(file);
    out.write(text);
    out.commit();
}

ProgramRun runGnuplot(const std::filesystem::path& folder, std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "gnuplot");
    ProgramRun ran = runProgram(folder, std::move(arguments));
    if (ran.error != 0)
    {
        throw Error(ErrorCode::missingProgram,
                    fmt::format("gnuplot cannot be run: {}; install it with: apt-get install "
                                "gnuplot-nox",
                                std::strerror(ran.error)));
    }
    return ran;
}

} // namespace

void requireGnuplot()
{
    static_cast<void>(runGnuplot(".", {"--version"}));
}

void drawAnalysis(const std::filesystem::path& folder, const std::vector<std::string>& names)
{
    writeScript(folder / "style.gp", embedded::plot_style());
    for (const AnalysisPlot& plot : kPlots)
    {
        if (std::find(names.begin(), names.end(), plot.table) == names.end())
        {
            continue;
        }
        writeScript(folder / plot.script, plot.text());
        for (const char* format : {"svg", "png"})
        {
            const ProgramRun ran =
                runGnuplot(folder, {"-e", fmt::format("format='{}'", format), plot.script});
            if (ran.code != 0)
            {
                throw Error(ErrorCode::writeFailed,
                            fmt::format("gnuplot failed on {}: {}", (folder / plot.script).string(),
                                        ran.said));
            }
        }
    }
}

} // namespace frostfill

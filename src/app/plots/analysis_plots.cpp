// SPDX-License-Identifier: MIT
#include "app/plots/analysis_plots.hpp"

#include "app/plots/embedded_scripts.hpp"
#include "base/atomic_file.hpp"
#include "base/run_program.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

namespace frostfill
{

std::string findMatplotlib()
{
    // Debian's Python has Debian's packages, even where another comes first.
    for (const char* python : {"python3", "/usr/bin/python3"})
    {
        const ProgramRun ran = runProgram(".", {python, "-c", "import matplotlib"});
        if (ran.error == 0 && ran.code == 0)
        {
            return python;
        }
    }
    throw Error(ErrorCode::missingProgram,
                "figures are drawn by Python's matplotlib, which is missing; install it with: "
                "apt-get install python3-matplotlib, or pip install matplotlib");
}

void drawAnalysis(const std::string& python, const std::filesystem::path& folder,
                  const std::vector<std::string>& names)
{
    AtomicFile script(folder / "figures.py");
    script.write(embedded::plot_figures());
    script.commit();
    std::vector<std::string> call = {python, "figures.py"};
    call.insert(call.end(), names.begin(), names.end());
    const ProgramRun ran = runProgram(folder, std::move(call));
    if (ran.error != 0 || ran.code != 0)
    {
        throw Error(
            ErrorCode::writeFailed,
            fmt::format("{} failed on {}: {}", python, (folder / "figures.py").string(), ran.said));
    }
}

} // namespace frostfill

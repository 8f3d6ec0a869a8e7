// SPDX-License-Identifier: MIT
#include "app/export_files.hpp"

#include "app/progress/progress.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/text/shell_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace frostfill
{
namespace
{

void printResult(const ExportResult& result)
{
    const std::size_t others = result.files.size() - 1;
    std::string line = result.files.front().string();
    line += others > 0 ? fmt::format(" and {} files beside it", others) : "";
    line += fmt::format(": {} {}", result.frames, result.frames == 1 ? "frame" : "frames");
    line += result.repeats > 0 ? fmt::format(" ({} more show the same times)", result.repeats) : "";
    line += fmt::format(", {} spheres, {:.3g} MB", result.spheres,
                        static_cast<double>(result.bytes) / 1e6);
    line += describe(result.shell);
    line += result.unitsPerMetre == 1
                ? "; lengths in metres"
                : fmt::format("; lengths in the unit of the mesh, {:g} in a metre",
                              result.unitsPerMetre);
    line += result.cells > 0
                ? fmt::format("; snappyHexMesh will make about {:.0f} thousand cells (--cell)",
                              std::ceil(result.cells / 1e3))
                : "";
    fmt::print("{}{}\n", line, result.unfinished ? "; the run has not ended" : "");
}

} // namespace

std::string exportFormatNames()
{
    std::string names;
    for (const ExportFormatInfo& format : exportFormats())
    {
        names += (names.empty() ? "" : ", ") + std::string(format.name);
    }
    return names;
}

std::vector<ExportRequest> exportRequests(const std::filesystem::path& run,
                                          const std::vector<std::string>& formats,
                                          const std::filesystem::path& out)
{
    std::error_code none;
    const std::filesystem::path home =
        std::filesystem::is_directory(run, none) ? run : run.parent_path();
    std::vector<ExportRequest> requests;
    for (const std::string& name : formats)
    {
        ExportRequest& request = requests.emplace_back();
        request.run = run;
        request.format = exportFormat(name).format;
        request.out = out.empty() ? home / "export" : out;
    }
    return requests;
}

void exportFiles(const std::vector<ExportRequest>& requests, bool quiet)
{
    for (const ExportRequest& request : requests)
    {
        TaskBar bar;
        const ExportResult result = exportRun(request, bar.untilStopped("frames", quiet));
        bar.close();
        if (!quiet)
        {
            printResult(result);
        }
    }
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
// What it costs to write the last state of a run in each format. Run it by hand:
// build/release/tests/benchmark/benchmark_export RUN FOLDER

#include <frostfill/error.hpp>
#include <frostfill/export.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <limits>

namespace
{

using namespace frostfill;

/// One node a sphere: a file for viewers of some thousands.
bool isForFew(ExportFormat format)
{
    return format == ExportFormat::glb;
}

void measure(const ExportRequest& request, const char* name)
{
    double seconds = std::numeric_limits<double>::max();
    ExportResult result;
    for (int repeat = 0; repeat < 3; ++repeat)
    {
        const std::clock_t start = std::clock();
        result = exportRun(request);
        seconds = std::min(seconds, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    const double megabytes = static_cast<double>(result.bytes) / 1e6;
    fmt::print("{:<14} {:>9} {:>8.1f} MB {:>7.2f} s {:>7.0f} MB/s\n", name, result.spheres,
               megabytes, seconds, megabytes / seconds);
}

} // namespace

int main(int count, char** arguments)
{
    if (count != 3)
    {
        fmt::print("benchmark_export RUN FOLDER\n");
        return static_cast<int>(ErrorCode::usage);
    }
    try
    {
        fmt::print("processor time with reading the run, the least of three\n");
        for (const ExportFormatInfo& format : exportFormats())
        {
            if (!isForFew(format.format))
            {
                measure({.run = arguments[1],
                         .format = format.format,
                         .frames = "last",
                         .out = arguments[2],
                         .overwrite = true},
                        format.name);
            }
        }
    }
    catch (const Error& error)
    {
        fmt::print("{}\n", error.what());
        return static_cast<int>(error.code());
    }
    return 0;
}

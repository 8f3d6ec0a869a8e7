// SPDX-License-Identifier: MIT
#include "base/atomic_file.hpp"
#include "base/statistics.hpp"
#include "run/run_files.hpp"

#include <fmt/format.h>

#include <numeric>

namespace frostfill
{
namespace
{

double sum(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

double percentile95(std::vector<double> values)
{
    return percentile(values, 0.95);
}

double total(const StageTimes& times)
{
    return std::accumulate(times.seconds.begin(), times.seconds.end(), 0.0);
}

/// Pictures a second, or steps where none was drawn: by the time of all stages.
double framesPerSecond(const SetRecord& set, const SetFrames& drawn)
{
    const double milliseconds =
        1000 * total(set.times) + sum(drawn.renderMs) + sum(drawn.readbackMs) + sum(drawn.encodeMs);
    const auto frames =
        static_cast<double>(drawn.renderMs.empty() ? set.steps : drawn.renderMs.size());
    return milliseconds > 0 ? 1000 * frames / milliseconds : 0;
}

std::string csvRow(const SetRecord& set, const SetFrames& drawn)
{
    std::string row = fmt::format("{},{},{},{},{:.9g},", set.set, set.spheres,
                                  drawn.renderMs.size(), set.steps, set.simulatedSeconds);
    for (double ms : {set.meanSphereSphereMs, set.p95SphereSphereMs, set.meanSpherePolygonMs,
                      set.p95SpherePolygonMs})
    {
        row += fmt::format("{:.6g},", ms);
    }
    for (const auto* ms : {&drawn.renderMs, &drawn.readbackMs, &drawn.encodeMs})
    {
        row += fmt::format("{:.6g},{:.6g},", mean(*ms), percentile95(*ms));
    }
    row += fmt::format("{:.6g},{:.6g},{:.6g},{},{},{},{},{},{},{}\n",
                       1000 * set.times[Stage::freezing], 1000 * set.times[Stage::discarding],
                       framesPerSecond(set, drawn), set.running, set.frozen, set.discarded,
                       set.discardedPolygons, set.operations.tests(), set.operations.responses(),
                       set.timedOut ? 1 : 0);
    return row;
}

constexpr const char* kCsvHeading =
    "set,spheres,frames,steps,simulated_seconds,"
    "mean_sphere_sphere_ms,p95_sphere_sphere_ms,mean_sphere_polygon_ms,p95_sphere_polygon_ms,"
    "mean_render_ms,p95_render_ms,mean_readback_ms,p95_readback_ms,mean_encode_ms,p95_encode_ms,"
    "freezing_ms,discarding_ms,frames_per_second,running,frozen,discarded,discarded_polygons,"
    "tests,responses,timed_out\n";

} // namespace

void writeSetsCsv(std::span<const SetRecord> sets, std::span<const SetFrames> frames,
                  const std::filesystem::path& file)
{
    AtomicFile out(file);
    out.write(kCsvHeading);
    for (const SetRecord& set : sets)
    {
        out.write(csvRow(set, set.set < frames.size() ? frames[set.set] : SetFrames{}));
    }
    out.commit();
}

} // namespace frostfill

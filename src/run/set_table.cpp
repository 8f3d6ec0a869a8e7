// SPDX-License-Identifier: MIT
#include "run/set_table.hpp"

#include "base/atomic_file.hpp"
#include "base/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
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

SetFrames framesOf(std::span<const SetFrames> frames, const SetRecord& set)
{
    return set.set < frames.size() ? frames[set.set] : SetFrames{};
}

double total(const StageTimes& times)
{
    return std::accumulate(times.seconds.begin(), times.seconds.end(), 0.0);
}

SetTiming summed(std::span<const SetRecord> sets, std::span<const SetFrames> frames)
{
    SetTiming row;
    double milliseconds = 0;
    for (const SetRecord& set : sets)
    {
        const SetFrames drawn = framesOf(frames, set);
        row.spheres += set.spheres;
        row.steps += set.steps;
        row.frames += drawn.renderMs.size();
        row.sphereSphereMs += 1000 * set.times[Stage::sphereSphere];
        row.spherePolygonMs += 1000 * set.times[Stage::spherePolygon];
        row.freezingMs += 1000 * set.times[Stage::freezing];
        row.discardingMs += 1000 * set.times[Stage::discarding];
        row.otherMs += 1000 * (set.times[Stage::motion] + set.times[Stage::releasing]);
        row.renderMs += sum(drawn.renderMs);
        row.readbackMs += sum(drawn.readbackMs);
        row.encodeMs += sum(drawn.encodeMs);
        milliseconds += 1000 * total(set.times) + sum(drawn.renderMs) + sum(drawn.readbackMs) +
                        sum(drawn.encodeMs);
    }
    row.running = sets.back().running;
    row.frozen = sets.back().frozen;
    row.discarded = sets.back().discarded;

    const auto pictures = static_cast<double>(row.frames > 0 ? row.frames : row.steps);
    if (pictures > 0)
    {
        for (double* ms :
             {&row.sphereSphereMs, &row.spherePolygonMs, &row.freezingMs, &row.discardingMs,
              &row.otherMs, &row.renderMs, &row.readbackMs, &row.encodeMs})
        {
            *ms /= pictures;
        }
    }
    row.framesPerSecond = milliseconds > 0 ? 1000 * pictures / milliseconds : 0;
    return row;
}

std::string csvRow(const SetRecord& set, const SetFrames& drawn, double framesPerSecond)
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
    row +=
        fmt::format("{:.6g},{:.6g},{:.6g},{},{},{},{},{},{},{}\n",
                    1000 * set.times[Stage::freezing], 1000 * set.times[Stage::discarding],
                    framesPerSecond, set.running, set.frozen, set.discarded, set.discardedPolygons,
                    set.operations.tests(), set.operations.responses(), set.timedOut ? 1 : 0);
    return row;
}

constexpr const char* kCsvHeading =
    "set,spheres,frames,steps,simulated_seconds,"
    "mean_sphere_sphere_ms,p95_sphere_sphere_ms,mean_sphere_polygon_ms,p95_sphere_polygon_ms,"
    "mean_render_ms,p95_render_ms,mean_readback_ms,p95_readback_ms,mean_encode_ms,p95_encode_ms,"
    "freezing_ms,discarding_ms,frames_per_second,running,frozen,discarded,discarded_polygons,"
    "tests,responses,timed_out\n";

} // namespace

std::vector<SetTiming> setTable(std::span<const SetRecord> sets, std::span<const SetFrames> frames,
                                std::size_t limit)
{
    std::vector<SetTiming> rows;
    const std::size_t perRow = (sets.size() + limit - 1) / std::max<std::size_t>(limit, 1);
    for (std::size_t first = 0; first < sets.size(); first += perRow)
    {
        const auto shared = sets.subspan(first, std::min(perRow, sets.size() - first));
        rows.push_back(summed(shared, frames));
        rows.back().name = shared.size() == 1
                               ? fmt::format("{}", shared.front().set)
                               : fmt::format("{}-{}", shared.front().set, shared.back().set);
    }
    if (!sets.empty())
    {
        rows.push_back(summed(sets, frames));
        rows.back().name = "all";
    }
    return rows;
}

std::string formatSetTable(std::span<const SetTiming> rows)
{
    if (rows.empty() || rows.back().frames == 0)
    {
        return {};
    }
    std::string text = fmt::format("{:>9} {:>7} {:>6} {:>9} | {:^62} | {:^22}\n", "", "", "",
                                   "frames/s", "milliseconds per frame", "spheres at its end");
    text += fmt::format("{:>9} {:>7} {:>6} {:>9} | {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7}"
                        "| {:>6} {:>7} {:>7}\n",
                        "set", "spheres", "frames", "", "sph-sph", "sph-pol", "freeze", "discard",
                        "other", "render", "read", "encode", "run", "frozen", "discard");
    for (const SetTiming& row : rows)
    {
        text += fmt::format("{:>9} {:>7} {:>6} {:>9.1f} | {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f} "
                            "{:>7.3f} {:>7.2f} {:>7.2f} {:>7.2f}| {:>6} {:>7} {:>7}\n",
                            row.name, row.spheres, row.frames, row.framesPerSecond,
                            row.sphereSphereMs, row.spherePolygonMs, row.freezingMs,
                            row.discardingMs, row.otherMs, row.renderMs, row.readbackMs,
                            row.encodeMs, row.running, row.frozen, row.discarded);
    }
    return text;
}

std::string setTableText(const FillResult& result, std::size_t mostRows)
{
    return formatSetTable(setTable(result.sets, result.setFrames, mostRows));
}

void writeSetsCsv(std::span<const SetRecord> sets, std::span<const SetFrames> frames,
                  const std::filesystem::path& file)
{
    AtomicFile out(file);
    out.write(kCsvHeading);
    for (const SetRecord& set : sets)
    {
        out.write(csvRow(set, framesOf(frames, set), summed({&set, 1}, frames).framesPerSecond));
    }
    out.commit();
}

} // namespace frostfill

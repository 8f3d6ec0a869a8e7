// SPDX-License-Identifier: MIT
#include "study/stability/stability_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <thread>

namespace frostfill
{
namespace
{

/// More spheres at once than this would take the paper's method, which tests all against all,
/// hours.
constexpr std::size_t kMaxAllPairs = 1000;
/// More than this would settle together for an hour, and more grains would move for as long.
constexpr std::size_t kMaxTogether = 10000;
constexpr std::size_t kMaxGrains = 1000;

StressOutcome outcomeOf(const StressCell& cell, const StressMethod& method)
{
    if (method.preset == Preset::paper && cell.atOnce > kMaxAllPairs)
    {
        StressOutcome none;
        none.verdict = Verdict::notRun;
        none.message = fmt::format("{} pairs a step", cell.atOnce * (cell.atOnce - 1) / 2);
        return none;
    }
    const std::size_t mostTogether = method.motion == Motion::granular ? kMaxGrains : kMaxTogether;
    if (method.rest == Rest::joint && cell.atOnce > mostTogether)
    {
        StressOutcome none;
        none.verdict = Verdict::notRun;
        none.message = "would settle for an hour";
        return none;
    }
    return runUnderStressTwice(cell.make(method));
}

/// The few numbers that tell how bad it was, short enough for a cell of the heat map.
std::string note(const StressOutcome& outcome)
{
    switch (outcome.verdict)
    {
    case Verdict::leaks:
        return fmt::format("{} out", outcome.outside);
    case Verdict::gainsEnergy:
        return fmt::format("E +{:.1e}", outcome.energyExcess);
    case Verdict::restless:
        return outcome.unsettled ? "unsettled" : fmt::format("{} restless", outcome.overdue);
    case Verdict::overlaps:
        return fmt::format("{:.1e} r", std::max(outcome.maxOverlap, outcome.maxWallOverlap));
    case Verdict::hangs:
        return fmt::format("{} hang", outcome.unsupported);
    default:
        return "";
    }
}

} // namespace

bool StabilityResult::sound() const
{
    const Verdict verdict = outcome.verdict;
    const bool passes = verdict == Verdict::passes || verdict == Verdict::notRun;
    const bool refused = verdict == Verdict::refused;
    const bool saysSo =
        outcome.unsettled && (verdict == Verdict::restless || verdict == Verdict::overlaps);
    if (expected == Expectation::either && saysSo)
    {
        return true;
    }
    return (passes && expected != Expectation::refuses) ||
           (refused && expected != Expectation::passes);
}

std::vector<StabilityResult> measureStability(bool quick, const StudyProgress& progress)
{
    const std::vector<StressCell> cells = stressMatrix(quick);
    std::vector<StabilityResult> results;
    for (const StressMethod& method : stressMethods())
    {
        for (const StressCell& cell : cells)
        {
            results.push_back(
                {method.name, method.preset, cell.axis, cell.label, cell.expectedOf(method), {}});
        }
    }

    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::size_t done = 0;
    const auto work = [&]
    {
        for (std::size_t k = next++; k < results.size(); k = next++)
        {
            results[k].outcome =
                outcomeOf(cells[k % cells.size()], stressMethods()[k / cells.size()]);
            const std::lock_guard lock(mutex);
            progress(
                ++done, results.size(),
                fmt::format("{}: {} {}", results[k].method, results[k].axis, results[k].label));
        }
    };
    std::vector<std::thread> threads;
    for (unsigned k = 1; k < std::max(1u, std::thread::hardware_concurrency()); ++k)
    {
        threads.emplace_back(work);
    }
    work();
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    return results;
}

Table stabilityCsv(const std::vector<StabilityResult>& results)
{
    Table table;
    table.headings = {"method",      "axis",          "value",       "row",
                      "column",      "verdict",       "code",        "sound",
                      "spheres",     "steps",         "outside",     "overdue",
                      "energy_gain", "energy_excess", "max_overlap", "max_wall_overlap",
                      "unsupported", "unsettled",     "seconds",     "state_hash",
                      "note",        "message"};
    std::map<std::string, std::size_t> rows;
    std::map<std::pair<std::string, std::string>, std::size_t> columns;
    for (const StabilityResult& one : results)
    {
        const std::size_t row = rows.emplace(one.axis, rows.size()).first->second;
        const std::size_t column = columns[{one.method, one.axis}]++;
        const StressOutcome& o = one.outcome;
        table.rows.push_back({one.method,
                              one.axis,
                              one.label,
                              fmt::format("{}", row),
                              fmt::format("{}", column),
                              verdictName(o.verdict),
                              fmt::format("{}", static_cast<int>(o.verdict)),
                              one.sound() ? "1" : "0",
                              fmt::format("{}", o.spheres),
                              fmt::format("{}", o.steps),
                              fmt::format("{}", o.outside),
                              fmt::format("{}", o.overdue),
                              fmt::format("{:.3e}", o.energyGain),
                              fmt::format("{:.3e}", o.energyExcess),
                              fmt::format("{:.3e}", o.maxOverlap),
                              fmt::format("{:.3e}", o.maxWallOverlap),
                              fmt::format("{}", o.unsupported),
                              o.unsettled ? "1" : "0",
                              fmt::format("{:.3f}", o.seconds),
                              o.hash,
                              note(o),
                              o.message});
    }
    return table;
}

Table stabilityTable(const std::vector<StabilityResult>& results)
{
    Table table;
    table.title = "Cells of the stress matrix by verdict";
    table.headings = {"method", "cells", "sound"};
    constexpr int kVerdicts = static_cast<int>(Verdict::hangs) + 1;
    for (int verdict = 0; verdict < kVerdicts; ++verdict)
    {
        table.headings.emplace_back(verdictName(static_cast<Verdict>(verdict)));
    }
    for (const StressMethod& method : stressMethods())
    {
        std::vector<std::size_t> counts(kVerdicts + 2);
        for (const StabilityResult& one : results)
        {
            if (one.method == method.name)
            {
                ++counts[0];
                counts[1] += one.sound() ? 1 : 0;
                ++counts[2 + static_cast<std::size_t>(one.outcome.verdict)];
            }
        }
        std::vector<std::string> row = {method.name};
        for (const std::size_t count : counts)
        {
            row.push_back(fmt::format("{}", count));
        }
        table.rows.push_back(row);
    }
    return table;
}

Table unsoundTable(const std::vector<StabilityResult>& results, Preset preset)
{
    Table table;
    table.title = preset == Preset::fast ? "Not sound, preset fast" : "Not sound, preset paper";
    table.words = 4;
    table.headings = {"method",  "axis",          "value",   "verdict",      "outside",
                      "overdue", "energy excess", "overlap", "wall overlap", "hanging"};
    for (const StabilityResult& one : results)
    {
        if (one.preset == preset && !one.sound())
        {
            table.rows.push_back({one.method, one.axis, one.label, verdictName(one.outcome.verdict),
                                  fmt::format("{}", one.outcome.outside),
                                  fmt::format("{}", one.outcome.overdue),
                                  fmt::format("{:.2e}", one.outcome.energyExcess),
                                  fmt::format("{:.1e}", one.outcome.maxOverlap),
                                  fmt::format("{:.1e}", one.outcome.maxWallOverlap),
                                  fmt::format("{}", one.outcome.unsupported)});
        }
    }
    return table;
}

} // namespace frostfill

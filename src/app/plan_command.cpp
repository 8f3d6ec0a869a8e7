// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/scene_options.hpp"

#include <frostfill/error.hpp>
#include <frostfill/plan.hpp>
#include <frostfill/shard.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kPlanExamples = R"(Examples:
  frostfill plan sweep.toml                     runs, time, memory and bytes of a sweep
  frostfill plan output/torus --frames 0..600   pictures, time and bytes of a rendering
)";

/// Machines of a cluster differ, and so do seeds: what is asked for is so many times the estimate.
constexpr double kMargin = 2;
constexpr double kSecondsMore = 120;    ///< for what begins slowly on a cluster
constexpr std::size_t kMaxTasks = 1000; ///< that clusters usually allow in an array

struct PlanArguments
{
    std::string what;
    std::size_t tasks = 0;
    GivenOptions given;
};

std::string durationText(double seconds)
{
    return seconds < 100    ? fmt::format("{:.2g} s", seconds)
           : seconds < 6000 ? fmt::format("{:.0f} min", seconds / 60)
                            : fmt::format("{:.1f} h", seconds / 3600);
}

std::string sizeText(double bytes)
{
    return bytes < 1e9 ? fmt::format("{:.1f} MB", bytes / 1e6)
                       : fmt::format("{:.1f} GB", bytes / 1e9);
}

/// HH:MM:SS, a whole number of minutes.
std::string slurmTime(double seconds)
{
    const auto minutes = static_cast<long>(std::ceil((kMargin * seconds + kSecondsMore) / 60));
    return fmt::format("{:02}:{:02}:00", minutes / 60, minutes % 60);
}

std::string slurmMemory(double bytes)
{
    constexpr double kStep = 100e6;
    return fmt::format("{:.0f}M", std::ceil(kMargin * bytes / kStep) * kStep / 1e6);
}

/// A line for each size of an array. `longest`: seconds of the slowest of so many tasks.
void printArrays(std::size_t asked, std::size_t most, double memory,
                 const std::function<double(std::size_t)>& longest)
{
    std::vector<std::size_t> sizes = {1, 4, 16, 64, 256};
    if (asked > 0)
    {
        sizes = {asked};
    }
    fmt::print("for sbatch, with {} times the estimate:\n", kMargin);
    for (const std::size_t tasks : sizes)
    {
        if (tasks <= std::min(most, kMaxTasks) || tasks == asked)
        {
            fmt::print(
                "  --array=0-{} --cpus-per-task=1 --time={} --mem={}   # {} a task at most\n",
                tasks - 1, slurmTime(longest(tasks)), slurmMemory(memory),
                durationText(longest(tasks)));
        }
    }
}

int printSweepPlan(const PlanArguments& arguments)
{
    const std::vector<SweepRun> runs = loadSweep(arguments.what);
    const std::vector<Cost> costs = planSweep(runs);
    Cost all;
    std::size_t failing = 0;
    for (const Cost& cost : costs)
    {
        failing += cost.failure.empty() ? 0 : 1;
        all.seconds += cost.seconds;
        all.bytes += cost.bytes;
        all.memory = std::max(all.memory, cost.memory);
    }
    fmt::print("{} runs; about {} on one core, {} of files, {} of memory\n", runs.size(),
               durationText(all.seconds), sizeText(all.bytes), sizeText(all.memory));
    if (failing > 0)
    {
        fmt::print("{} of them would fail; frostfill sweep --dry-run says why\n", failing);
    }
    printArrays(arguments.tasks, runs.size(), all.memory,
                [&](std::size_t tasks)
                {
                    std::vector<double> seconds(tasks, 0);
                    for (std::size_t k = 0; k < costs.size(); ++k)
                    {
                        seconds[k % tasks] += costs[k].seconds;
                    }
                    return *std::max_element(seconds.begin(), seconds.end());
                });
    return 0;
}

int printRenderPlan(const PlanArguments& arguments)
{
    RenderRequest request;
    request.run = arguments.what;
    request.change = [&](Scene& scene) { applyGivenOptions(arguments.given, scene); };
    const RenderPlan plan = planRender(request);
    const auto pictures = static_cast<double>(plan.pictures);
    fmt::print("{} pictures; about {} on one core, {} of files, {} of memory\n", plan.pictures,
               durationText(plan.secondsBefore + pictures * plan.secondsPerPicture),
               sizeText(pictures * plan.bytesPerPicture), sizeText(plan.memory));
    printArrays(arguments.tasks, plan.pictures, plan.memory,
                [&](std::size_t tasks)
                {
                    const double most = std::ceil(pictures / static_cast<double>(tasks));
                    return plan.secondsBefore + most * plan.secondsPerPicture;
                });
    return 0;
}

int printPlan(const PlanArguments& arguments)
{
    const bool isSweep = std::filesystem::path(arguments.what).extension() == ".toml";
    if (isSweep && !arguments.given.empty())
    {
        throw Error(ErrorCode::usage,
                    "the options of pictures are for a RUN; a sweep has them in its [scene]");
    }
    return isSweep ? printSweepPlan(arguments) : printRenderPlan(arguments);
}

} // namespace

Command addPlanCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<PlanArguments>();
    CLI::App* command = program.add_subcommand(
        "plan", "Estimate what a sweep or a rendering takes, and which job array to request");
    command->footer(kPlanExamples);
    command->add_option("WHAT", arguments->what, "A sweep (FILE.toml), or the directory of a run")
        ->required();
    command->add_option("--tasks", arguments->tasks, "Tasks of the job array (several choices)")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}));
    addPictureOptions(*command, arguments->given);
    return [arguments] { return printPlan(*arguments); };
}

} // namespace frostfill

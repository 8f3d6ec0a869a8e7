// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/packing_mesh.hpp"
#include "app/progress/message.hpp"
#include "app/scene_options.hpp"
#include "run/run_files.hpp"

#include <frostfill/error.hpp>
#include <frostfill/packing.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kCheckExamples = R"(Examples:
  frostfill check output/torus                                a run of our own, against its mesh
  frostfill check packing.csv --mesh part.stl --up z --max-overlap 0.01
  frostfill check dump.lammpstrj --mesh box.stl --json
  frostfill check beads.csv --columns x=px,y=py,z=pz,diameter=size --mesh tube.stl
  frostfill check output/torus --set judge.friction=0.3       does it stand as a whole?
)";

struct CheckArguments
{
    std::string file;
    PackingPlace place;
    PackingArguments packing;
    std::optional<double> mostOverlap, mostWallOverlap;
    std::optional<std::size_t> mostOutside, mostUnsupported, mostUnbalanced;
    bool json = false;
    GivenOptions given;
};

/// What is more than it may be, each in a few words.
std::vector<std::string> exceeded(const CheckArguments& arguments, const QualityReport& quality)
{
    std::vector<std::string> faults;
    const auto compare = [&](const auto& most, auto value, const char* what)
    {
        if (most && value > *most)
        {
            faults.push_back(fmt::format("{} {:.4g}, more than {:.4g}", what,
                                         static_cast<double>(value), static_cast<double>(*most)));
        }
    };
    compare(arguments.mostOverlap, quality.maxOverlap, "largest overlap");
    compare(arguments.mostWallOverlap, quality.maxWallOverlap, "largest overlap with a wall");
    compare(arguments.mostOutside, quality.centresOutside + quality.notFinite, "centres outside");
    compare(arguments.mostUnsupported, quality.unsupported, "unsupported spheres");
    if (quality.equilibrium)
    {
        compare(arguments.mostUnbalanced, quality.equilibrium->unbalanced, "unbalanced spheres");
    }
    return faults;
}

void row(const std::string& what, const std::string& value)
{
    fmt::print("{:<28} {}\n", what, value);
}

void printEquilibrium(const EquilibriumReport& joint)
{
    row(fmt::format("unbalanced, friction {:g}", joint.friction),
        fmt::format("{} of {} at rest; at most {:.3g} of the weight is missing{}", joint.unbalanced,
                    joint.spheres, joint.largest,
                    joint.settled ? "" : " (an upper bound: forces had not settled)"));
    row("stands from a friction of",
        std::isfinite(joint.leastFriction)
            ? fmt::format("{:.3g}", joint.leastFriction)
            : fmt::format("none up to {:g}", JudgeSettings::kMostFriction));
}

void printTable(const Packing& packing, const QualityReport& quality, bool hasWalls)
{
    const auto [smallest, largest] =
        std::minmax_element(packing.radii.begin(), packing.radii.end());
    row("spheres", fmt::format("{}, from {}", packing.centres.size(), packing.format));
    row("radii", *smallest == *largest ? fmt::format("{:.6g}", *largest)
                                       : fmt::format("{:.6g} to {:.6g}", *smallest, *largest));
    row("largest overlap", fmt::format("{:.4g} of the smaller radius", quality.maxOverlap));
    if (!hasWalls)
    {
        return;
    }
    row("mean overlap of contacts",
        fmt::format("{:.4g} of the smaller radius", quality.meanOverlap));
    row("largest overlap with a wall", fmt::format("{:.4g} of the radius", quality.maxWallOverlap));
    row("centres outside the mesh", fmt::format("{}", quality.centresOutside));
    row("centres that are not finite", fmt::format("{}", quality.notFinite));
    const auto resting = std::count(packing.atRest.begin(), packing.atRest.end(), true);
    row("unsupported spheres", fmt::format("{} of {} at rest", quality.unsupported, resting));
    if (quality.equilibrium)
    {
        printEquilibrium(*quality.equilibrium);
    }
    row("volume of the mesh", fmt::format("{:.6g}", quality.meshVolume));
    row("volume of the spheres", fmt::format("{:.6g}, {:.2f} % of it", quality.sphereVolume,
                                             100 * quality.sphereVolume / quality.meshVolume));
}

void printJson(const Packing& packing, const QualityReport& quality, bool hasWalls,
               const std::vector<std::string>& faults)
{
    const auto [smallest, largest] =
        std::minmax_element(packing.radii.begin(), packing.radii.end());
    nlohmann::ordered_json json = {
        {"format", packing.format},
        {"spheres", packing.centres.size()},
        {"at_rest", std::count(packing.atRest.begin(), packing.atRest.end(), true)},
        {"smallest_radius", *smallest},
        {"largest_radius", *largest}};
    if (hasWalls)
    {
        json.update(qualityJson(quality));
    }
    else
    {
        json["max_overlap_over_radius"] = quality.maxOverlap;
    }
    json["exceeded"] = faults;
    fmt::print("{}\n", json.dump(2));
}

int check(const CheckArguments& arguments)
{
    const Packing packing = readPacking(arguments.file, arguments.packing.options());
    Scene scene;
    scene.object.up = packing.up.value_or(scene.object.up);
    applyGivenOptions(arguments.given, scene);
    const bool asks =
        arguments.mostUnbalanced || scene.judge.unbalance != JudgeSettings{}.unbalance;
    if (asks && !scene.judge.friction)
    {
        throw Error(ErrorCode::usage,
                    "--max-unbalanced and judge.unbalance need a friction under which "
                    "spheres are balanced: give --set judge.friction=...");
    }
    const PackingWalls walls = wallsOf(packing, arguments.place, scene.object.load);
    const bool hasWalls = walls.bounds == AnalysisBounds::walls;
    if (!hasWalls && (arguments.mostWallOverlap || arguments.mostOutside ||
                      arguments.mostUnsupported || scene.judge.friction))
    {
        throw Error(ErrorCode::usage, "without walls only overlaps of spheres are judged: give a "
                                      "--mesh, or a --box that is not --periodic");
    }
    const QualityReport quality = judgePacking(walls, packing, scene.object.up, scene.judge);
    const std::vector<std::string> faults = exceeded(arguments, quality);
    if (arguments.json)
    {
        printJson(packing, quality, hasWalls, faults);
    }
    else
    {
        printTable(packing, quality, hasWalls);
    }
    if (!faults.empty())
    {
        say(fmt::format("frostfill: {}: {}\n", arguments.file, fmt::join(faults, "; ")));
        return static_cast<int>(ErrorCode::thresholdFailed);
    }
    return 0;
}

} // namespace

Command addCheckCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<CheckArguments>();
    CLI::App* command = program.add_subcommand(
        "check",
        "Judge a packing from any program: overlaps, walls, centres outside, support, balance");
    command->footer(std::string(kCheckExamples) + kPackingFiles);
    command->add_option("FILE", arguments->file, "The packing")->required();
    addPackingMeshOption(*command, arguments->place);
    addPackingOptions(*command, arguments->packing);
    addSceneOptions(*command, arguments->given);
    const auto limit = [&](const char* flag, auto& value, const char* help, const char* type)
    { command->add_option(flag, value, help)->check(CLI::NonNegativeNumber)->type_name(type); };
    limit("--max-overlap", arguments->mostOverlap,
          "Exit with 2 if two spheres overlap by more of the smaller radius", "X");
    limit("--max-wall-overlap", arguments->mostWallOverlap,
          "The same for a sphere and the mesh, of its radius", "X");
    limit("--max-outside", arguments->mostOutside,
          "Exit with 2 if more centres are outside, or are not numbers", "N");
    limit("--max-unsupported", arguments->mostUnsupported,
          "Exit with 2 if more spheres at rest have no support", "N");
    limit("--max-unbalanced", arguments->mostUnbalanced,
          "Exit with 2 if more spheres are unbalanced; needs judge.friction", "N");
    command->add_flag("--json", arguments->json, "Print JSON");
    return [arguments] { return check(*arguments); };
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/packing_mesh.hpp"
#include "app/plots/analysis_plots.hpp"
#include "app/progress/message.hpp"
#include "app/scene_options.hpp"

#include <frostfill/analysis.hpp>
#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <type_traits>

namespace frostfill
{
namespace
{

constexpr const char* kAnalyseExamples = R"(Examples:
  frostfill analyse output/torus                      tables in output/torus/analysis
  frostfill analyse packing.csv --mesh part.stl --up z --figures
  frostfill analyse dump.lammpstrj --mesh tube.stl --only porosity,pairs --json
  frostfill analyse dump.lammpstrj --box 10,10,10 --periodic      without a mesh
)";

struct AnalyseArguments
{
    std::string file;
    PackingPlace place;
    PackingArguments packing;
    AnalysisSettings settings;
    std::vector<double> centre;
    std::vector<std::string> only;
    std::string out;
    bool figures = false;
    bool json = false;
    bool overwrite = false;
    bool quiet = false;
    GivenOptions given;
};

/// In or beside a run; of a file of others, where runs are.
std::filesystem::path folderOf(const AnalyseArguments& arguments, const Packing& packing)
{
    if (!arguments.out.empty())
    {
        return arguments.out;
    }
    const std::filesystem::path file = arguments.file;
    if (std::filesystem::is_directory(file))
    {
        return file / "analysis";
    }
    return packing.mesh ? file.parent_path() / "analysis"
                        : std::filesystem::path("output") / ("analysis-" + file.stem().string());
}

AnalysisSettings settingsOf(const AnalyseArguments& arguments)
{
    AnalysisSettings settings = arguments.settings;
    for (const std::string& name : arguments.only)
    {
        settings.only.push_back(analysisKind(name));
    }
    if (!arguments.centre.empty())
    {
        settings.centre =
            Eigen::Vector3d(arguments.centre[0], arguments.centre[1], arguments.centre[2]);
    }
    return settings;
}

void printRow(const char* what, const std::string& value)
{
    fmt::print("{:<30} {}\n", what, value);
}

/// A number, or that there is none.
std::string textOf(double value)
{
    return std::isfinite(value) ? fmt::format("{:.5g}", value)
                                : "none: no sphere is far enough from walls and surface";
}

void printPorosity(const PackingAnalysis& analysis)
{
    const PorosityProfiles& porosity = *analysis.porosity;
    printRow(
        "porosity of the bed",
        fmt::format("{:.5f} +- {:.5f} below {}", porosity.whole.porosity, porosity.whole.error,
                    analysis.settings.below ? "the height that was given" : "its topmost spheres"));
    printRow("porosity of the bulk",
             porosity.bulk
                 ? fmt::format("{:.5f} +- {:.5f}", porosity.bulk->porosity, porosity.bulk->error)
                 : "none: no place is far enough from walls and surface");
    fmt::print("  ({})\n", bulkInWords());
}

void printTable(const PackingAnalysis& analysis)
{
    printRow("spheres", fmt::format("{}", analysis.ids.size()));
    if (analysis.outside + analysis.notFinite > 0)
    {
        printRow("left out", fmt::format("{} outside the mesh, {} whose place is no number",
                                         analysis.outside, analysis.notFinite));
    }
    printRow("volume of the spheres",
             analysis.settings.bounds == AnalysisBounds::none
                 ? fmt::format("{:.6g}", analysis.sphereVolume)
                 : fmt::format("{:.6g}, {:.2f} % of the {}", analysis.sphereVolume,
                               100 * analysis.sphereVolume / analysis.meshVolume,
                               analysis.settings.bounds == AnalysisBounds::walls ? "mesh" : "box"));
    if (analysis.porosity)
    {
        printPorosity(analysis);
    }
    if (analysis.pairs)
    {
        printRow("g(r)", fmt::format("up to {:.4g}, of {} spheres", analysis.pairs->range,
                                     analysis.pairs->centres));
    }
    if (analysis.contacts)
    {
        printRow("contacts with spheres", fmt::format("{:.4f}", analysis.contacts->mean));
        printRow("  away from walls and surface", textOf(analysis.contacts->meanInside));
        printRow("  without rattlers", fmt::format("{:.4f}; {} rattle", analysis.contacts->meanHeld,
                                                   analysis.contacts->rattlers));
        if (analysis.settings.forces)
        {
            printRow("  forces under this friction",
                     fmt::format("{:g}; at most {:.3g} of its weight is missing on a sphere",
                                 *analysis.settings.forces, analysis.contacts->unbalance));
        }
    }
    if (analysis.cells)
    {
        printRow("Voronoi cells",
                 fmt::format("{} whole, {} cut by walls, {} open", analysis.cells->whole,
                             analysis.cells->atWall, analysis.cells->open));
        printRow("  packing fraction in them", textOf(analysis.cells->fraction));
    }
    if (analysis.order)
    {
        printRow("Q6", fmt::format("{} of a sphere, {} of all", textOf(analysis.order->mean),
                                   textOf(analysis.order->global)));
    }
    if (analysis.sizes && std::isfinite(analysis.sizes->withHeight))
    {
        printRow("correlation of radius with",
                 fmt::format("height {:.3f}, distance from the axis {:.3f}",
                             analysis.sizes->withHeight, analysis.sizes->withRadial));
    }
}

int analyse(const AnalyseArguments& arguments)
{
    AnalysisSettings settings = settingsOf(arguments);
    const Packing packing = readPacking(arguments.file, arguments.packing.options());
    Scene scene;
    scene.object.up = packing.up.value_or(scene.object.up);
    applyGivenOptions(arguments.given, scene);
    settings.up = scene.object.up;
    const std::filesystem::path folder = folderOf(arguments, packing);
    if (!arguments.overwrite)
    {
        refuseToReplaceAnalysis(folder, "give --overwrite, or another --out");
    }
    const std::string python = arguments.figures ? findMatplotlib() : "";
    const PackingWalls walls = wallsOf(packing, arguments.place, scene.object.load);
    settings.bounds = walls.bounds;
    const PackingAnalysis analysis = analysePacking(walls.mesh, packing, settings);
    const std::vector<std::string> names = writeAnalysis(analysis, folder);
    if (arguments.figures)
    {
        drawAnalysis(python, folder, names);
    }
    if (arguments.json)
    {
        fmt::print("{}", analysisSummary(analysis));
    }
    else if (!arguments.quiet)
    {
        printTable(analysis);
        fmt::print("tables in {}\n", folder.string());
    }
    if (settings.only.empty() && !hasVoronoiCells() && !arguments.quiet)
    {
        say(fmt::format("left out: {}\n", missingVoronoiCells()));
    }
    return 0;
}

void addSettings(CLI::App& command, AnalyseArguments& arguments)
{
    AnalysisSettings& settings = arguments.settings;
    const auto add = [&](const char* flag, auto& value, const char* help)
    {
        return command.add_option(flag, value, fmt::format("{} ({})", help, value))
            ->type_name(std::is_floating_point_v<std::remove_reference_t<decltype(value)>> ? "X"
                                                                                           : "N");
    };
    command
        .add_option(
            "--only", arguments.only,
            fmt::format("Only these, separated by commas: {}", fmt::join(analysisNames(), ", ")))
        ->delimiter(',')
        ->type_name("NAMES");
    command
        .add_option("--centre", arguments.centre,
                    "A point of the axis of radial profiles (the middle of the mesh's box)")
        ->delimiter(',')
        ->expected(3)
        ->type_name("X,Y,Z");
    command
        .add_option("--below", settings.below,
                    "Height above the foot of the mesh at which the bed ends (at its topmost "
                    "spheres)")
        ->type_name("HEIGHT");
    command
        .add_option("--forces", settings.forces,
                    "Also find the forces in contacts, under this friction")
        ->type_name("FRICTION");
    add("--bins", settings.bins, "Bins of a profile along or about the axis");
    add("--range", settings.range,
        "How far g(r) and the profile from the wall go, in mean diameters");
    add("--gap", settings.contactGap, "Gap of two spheres in contact, in smaller radii");
    add("--bond", settings.bondLength,
        "Distance of two that are bonded for Q6, in sums of their radii");
    add("--rattlers-below", settings.rattlersBelow,
        "Contacts, those with walls included, that a sphere needs to be held");
    add("--samples", settings.samples, "Places at which porosity is sampled");
    add("--threads", settings.threads, "Threads; 0: one for each core");
}

} // namespace

Command addAnalyseCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<AnalyseArguments>();
    CLI::App* command = program.add_subcommand(
        "analyse",
        "Analyse a packing from any program: porosity, g(r), contacts, Voronoi cells, Q6, "
        "sizes");
    command->footer(std::string(kAnalyseExamples) + kPackingFiles);
    command->add_option("FILE", arguments->file, "The packing")->required();
    addPackingMeshOption(*command, arguments->place);
    addSceneOptions(*command, arguments->given);
    addPackingOptions(*command, arguments->packing);
    addSettings(*command, *arguments);
    command
        ->add_option("--out", arguments->out,
                     "Folder of the tables (analysis, in the run, or output/analysis-NAME)")
        ->type_name("DIR");
    command->add_flag("--figures", arguments->figures,
                      "Draw a figure of each analysis with matplotlib");
    command->add_flag("--json", arguments->json, "Print summary.json");
    command->add_flag("--overwrite", arguments->overwrite, "Replace an earlier analysis");
    command->add_flag("--quiet", arguments->quiet, "Print nothing but errors");
    return [arguments] { return analyse(*arguments); };
}

} // namespace frostfill

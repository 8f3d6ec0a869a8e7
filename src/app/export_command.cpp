// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/text/result_text.hpp"

#include <frostfill/columns.hpp>
#include <frostfill/export.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

constexpr const char* kExportExamples = R"(Examples:
  frostfill export output/torus --to vtp                 for ParaView: open output/torus/export/run.pvd
  frostfill export output/torus --to glb --frames 0..600:10
  frostfill export output/torus --to csv,lammps --out tables
)";

struct ExportArguments
{
    std::string run;
    std::vector<std::string> formats;
    std::string frames;
    std::string out;
    bool fullMesh = false;
    bool noShell = false;
    bool lids = false;
    std::string contacts;
    BedSettings bed;
    std::vector<std::string> measured;
    bool overwrite = false;
    bool quiet = false;
};

void printResult(const ExportResult& result)
{
    const std::size_t others = result.files.size() - 1;
    std::string line = result.files.front().string();
    line += others > 0 ? fmt::format(" and {} beside it", counted(others, "file")) : "";
    line += fmt::format(": {}", counted(result.frames, "frame"));
    line += result.repeats > 0 ? fmt::format(" ({} more show the same times)", result.repeats) : "";
    line += fmt::format(", {} spheres, {:.3g} MB", result.spheres,
                        static_cast<double>(result.bytes) / 1e6);
    line += describe(result.shell);
    line += result.unitsPerMetre == 1
                ? "; lengths in metres"
                : fmt::format("; lengths in the unit of the mesh, {:g} in a metre",
                              result.unitsPerMetre);
    line += result.cells > 0
                ? fmt::format("; a mesher will make about {:.0f} thousand cells (--cell)",
                              std::ceil(result.cells / 1e3))
                : "";
    fmt::print("{}{}\n", line, result.unfinished ? "; the run has not ended" : "");
}

std::string exportFormatNames()
{
    std::string names;
    for (const ExportFormatInfo& format : exportFormats())
    {
        names += (names.empty() ? "" : ", ") + std::string(format.name);
    }
    return names;
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

std::string describeFormats()
{
    std::string text = "Formats:\n";
    for (const ExportFormatInfo& format : exportFormats())
    {
        text += fmt::format("  {:<14}{}, {}\n", format.name, format.purpose,
                            format.frames == std::string("all") ? "all frames by default"
                                                                : "the last frame by default");
    }
    return text + "\n";
}

int exportAll(const ExportArguments& arguments, const CLI::App& command)
{
    // All is checked before the first file is written.
    BedSettings bed = arguments.bed;
    if (!arguments.contacts.empty())
    {
        parseContacts(arguments.contacts, bed);
    }
    checkBedSettings(bed);
    const std::filesystem::path run = arguments.run;
    std::error_code none;
    const std::filesystem::path home =
        std::filesystem::is_directory(run, none) ? run : run.parent_path();
    std::vector<ExportRequest> requests;
    for (const std::string& name : arguments.formats)
    {
        ExportRequest& request = requests.emplace_back();
        request.run = run;
        request.format = exportFormat(name).format;
        request.out = arguments.out.empty() ? (home / "export").string() : arguments.out;
        request.frames = arguments.frames;
        request.fullMesh = arguments.fullMesh;
        request.shell = !arguments.noShell;
        request.lids = arguments.lids;
        request.bed = bed;
        request.measured = arguments.measured;
        request.overwrite = arguments.overwrite;
        for (const std::string_view option : exportOptions())
        {
            if (command.count(fmt::format("--{}", option)) > 0)
            {
                requireOption(request.format, option);
            }
        }
    }
    catchStopSignals();
    runHasBegun();
    exportFiles(requests, arguments.quiet);
    return 0;
}

void addGeometryOptions(CLI::App& command, ExportArguments& arguments)
{
    BedSettings& bed = arguments.bed;
    command
        .add_option(
            "--contacts", arguments.contacts,
            "Geometry: where spheres touch: none, shrink:FACTOR, and for stl-bed and openfoam "
            "caps:GAP, in radii (shrink:0.99)")
        ->type_name("HOW");
    command
        .add_option(
            "--resolution", bed.resolution,
            fmt::format("stl-bed, openfoam: a sphere has 20 N^2 triangles ({})", bed.resolution))
        ->type_name("N");
    command.add_flag("--ascii", bed.ascii, "stl-bed: text, with a named solid for each patch");
    command
        .add_option(
            "--cell", bed.cell,
            fmt::format("openfoam, gmsh: largest edge of a cell, in mean diameters ({})", bed.cell))
        ->type_name("X");
    command
        .add_option("--voxels", bed.voxels,
                    fmt::format("vti, npy: voxels along the longest side ({})", bed.voxels))
        ->type_name("N");
    command.add_option("--threads", bed.threads, "Geometry: threads; 0: one for each core")
        ->type_name("N");
}

} // namespace

Command addExportCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<ExportArguments>();
    CLI::App* command =
        program.add_subcommand("export", "Write a kept run in the formats of other programs");
    command->footer(describeFormats() + kExportExamples);
    command->add_option("RUN", arguments->run, "The folder of a run, or its run.frost")->required();
    command
        ->add_option("--to", arguments->formats,
                     fmt::format("Formats, separated by commas: {}", exportFormatNames()))
        ->required()
        ->delimiter(',')
        ->type_name("FORMAT");
    command
        ->add_option("--frames", arguments->frames,
                     "Frames to write, as for fill: all, last, numbers, ranges")
        ->type_name("SELECTION");
    command->add_option("--out", arguments->out, "Folder to write to [export, beside the run file]")
        ->type_name("DIR");
    command->add_flag("--full-mesh", arguments->fullMesh,
                      fmt::format("{}: in glTF", kFullMeshHelp));
    command->add_flag("--no-shell", arguments->noShell, "Leave out the object: in glTF");
    command->add_flag("--lids", arguments->lids,
                      "liggghts, lammps, yade: keep the lids of --lid among the walls");
    command
        ->add_option("--measure", arguments->measured,
                     fmt::format("vtp, lammps-dump, xyz, glb, glb-instanced, csv: columns that "
                                 "are found for spheres at rest, as by analyse: {}",
                                 fmt::join(measuredNames(), ", ")))
        ->delimiter(',')
        ->type_name("NAMES");
    addGeometryOptions(*command, *arguments);
    command->add_flag("--overwrite", arguments->overwrite, "Replace files of an earlier export");
    command->add_flag("--quiet", arguments->quiet, "Print nothing but errors");
    return [arguments, command] { return exportAll(*arguments, *command); };
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/scene_options.hpp"

#include <frostfill/import.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>

namespace frostfill
{
namespace
{

constexpr const char* kImportExamples = R"(Examples:
  frostfill import dump.lammpstrj --mesh hopper.stl --up z --timestep 1e-6
  frostfill import frames.xyz --radius 0.5                the box of the file is drawn
  frostfill render output/dump --style studio             then as a run of our own
  frostfill export output/dump --to vtp

FILE is a dump of LAMMPS or LIGGGHTS (columns id x y z radius), or extended XYZ, of all steps.
)";

struct ImportArguments
{
    ImportRequest request;
    std::string file;
    std::string directory;
    bool quiet = false;
    GivenOptions given;
};

std::string describeStates(const ImportResult& result)
{
    if (result.statesGiven)
    {
        return fmt::format("{} at rest, as the file says", result.atRest);
    }
    if (result.steps == 1)
    {
        return "all count as at rest: one step shows no motion";
    }
    return fmt::format(
        "{} of them count as at rest, because they stay within 1/1000 of their radius",
        result.atRest);
}

void printResult(const ImportResult& result)
{
    if (!result.torn.empty())
    {
        say(fmt::format("the last step is incomplete and left out: {}\n", result.torn));
    }
    if (result.repeats > 0)
    {
        say(fmt::format("{} steps occur twice and count once\n", result.repeats));
    }
    fmt::print("{}: {} {} from {:.6g} s to {:.6g} s\n", result.format, result.steps,
               result.steps == 1 ? "step" : "steps", result.begin, result.end);
    fmt::print("{} spheres at the end, radii {:.6g} to {:.6g}; {}\n", result.spheres,
               result.smallestRadius, result.largestRadius, describeStates(result));
    if (result.vanished > 0)
    {
        fmt::print("{} spheres vanish before the end; other spheres take their ids\n",
                   result.vanished);
    }
    if (result.boxDrawn)
    {
        fmt::print("no --mesh: the box of the file is drawn\n");
    }
    fmt::print("results in {}; see frostfill render and frostfill export\n",
               result.directory.string());
}

/// CLI11's own check names the largest double.
std::string requireAboveZero(const std::string& text)
{
    double value = 0;
    return CLI::detail::lexical_cast(text, value) && value > 0
               ? ""
               : fmt::format("'{}' is no number above 0", text);
}

int importFile(ImportArguments& arguments)
{
    ImportRequest& request = arguments.request;
    request.file = arguments.file;
    request.directory = arguments.directory.empty()
                            ? std::filesystem::path("output") / request.file.stem()
                            : std::filesystem::path(arguments.directory);
    Scene scene;
    applyGivenOptions(arguments.given, scene);
    request.up = scene.object.up;
    catchStopSignals();
    runHasBegun();
    TaskBar bar;
    const ImportResult result = importRun(request, bar.untilStopped("steps", arguments.quiet));
    bar.close();
    if (!arguments.quiet)
    {
        printResult(result);
    }
    return 0;
}

} // namespace

Command addImportCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<ImportArguments>();
    CLI::App* command = program.add_subcommand(
        "import", "Turn the simulation of another program into a run, to render and export it");
    command->footer(kImportExamples);
    command->add_option("FILE", arguments->file, "The dump or the XYZ file")->required();
    ImportRequest& request = arguments->request;
    command
        ->add_option("--mesh", request.mesh,
                     "The mesh around the spheres: a file, which may be open, or torus, sphere, "
                     "cube, human (the box of the file)")
        ->type_name("MESH");
    addSceneOptions(*command, arguments->given);
    command
        ->add_option("--timestep", request.timeStep,
                     "Seconds between two steps; needed where the file has no times")
        ->check(requireAboveZero)
        ->type_name("S");
    command->add_option("--radius", request.radius, "Radius of all spheres of a file without radii")
        ->check(requireAboveZero)
        ->type_name("R");
    command->add_option("--out", arguments->directory, "Directory of the run (output/NAME)")
        ->type_name("DIR");
    command->add_flag("--overwrite", request.overwrite, "Replace an earlier run");
    command->add_flag("--quiet", arguments->quiet, "Print errors only");
    return [arguments] { return importFile(*arguments); };
}

} // namespace frostfill

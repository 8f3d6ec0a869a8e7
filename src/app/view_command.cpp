// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/progress/message.hpp"
#include "app/progress/stop_signals.hpp"
#include "app/text/result_text.hpp"
#include "app/view_text.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace frostfill
{
namespace
{

constexpr const char* kViewExamples = R"(Examples:
  frostfill view output/torus                      open output/torus/view.html in a browser
  frostfill view output/torus --out torus.html --max-size 5
)";

struct ViewArguments
{
    std::string run;
    std::string file;
    double megabytes = 40;
    bool fullMesh = false;
    bool overwrite = false;
    bool quiet = false;
};

int runView(const ViewArguments& arguments)
{
    PageRequest request;
    request.run = arguments.run;
    request.file = arguments.file;
    request.maxBytes = static_cast<std::uint64_t>(1e6 * arguments.megabytes);
    request.fullMesh = arguments.fullMesh;
    request.overwrite = arguments.overwrite;
    catchStopSignals();
    runHasBegun();
    writePageWithProgress(request, arguments.quiet);
    return 0;
}

} // namespace

Command addViewCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<ViewArguments>();
    CLI::App* command =
        program.add_subcommand("view", "Write a kept run as one HTML page for any browser");
    command->footer(kViewExamples);
    command->add_option("RUN", arguments->run, "Directory of a run that was kept, or its run.frost")
        ->required();
    command->add_option("--out", arguments->file, "The page (view.html, in the folder of RUN)")
        ->type_name("FILE");
    command
        ->add_option("--max-size", arguments->megabytes,
                     "Show the last frame alone if a page with motion were larger (40 MB)")
        ->type_name("MB")
        ->check(CLI::Range(0.1, 2000.0));
    command->add_flag("--full-mesh", arguments->fullMesh, kFullMeshHelp);
    command->add_flag("--overwrite", arguments->overwrite, "Replace an earlier page");
    command->add_flag("--quiet", arguments->quiet, "Print errors only");
    return [arguments] { return runView(*arguments); };
}

} // namespace frostfill

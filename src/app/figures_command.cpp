// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/message.hpp"
#include "app/progress.hpp"
#include "study/figures/figure.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

namespace frostfill
{
namespace
{

constexpr const char* kExamples = R"(Examples:
  frostfill figures                          all figures into docs/figures, with recorded times
  frostfill figures --measure                with new times; use an idle machine
  frostfill figures --only operations --out output/figures
)";

struct FiguresArguments
{
    std::vector<std::string> only;
    FigureRequest request;
    std::string directory = "docs/figures";
    std::string recorded = "docs/figures";
    bool list = false;
    bool quiet = false;
};

int listFigures()
{
    for (const Figure& figure : allFigures())
    {
        fmt::print("{:12} {}{}\n", figure.name, figure.title,
                   figure.measured ? " (measured times)" : "");
    }
    return 0;
}

bool wanted(const FiguresArguments& arguments, const Figure& figure)
{
    return arguments.only.empty() || std::find(arguments.only.begin(), arguments.only.end(),
                                               figure.name) != arguments.only.end();
}

int figures(FiguresArguments& arguments)
{
    if (arguments.list)
    {
        return listFigures();
    }
    FigureRequest& request = arguments.request;
    request.directory = arguments.directory;
    request.recorded = arguments.recorded;
    std::vector<Figure> chosen;
    std::copy_if(allFigures().begin(), allFigures().end(), std::back_inserter(chosen),
                 [&](const Figure& figure) { return wanted(arguments, figure); });
    const auto secondsOf = [&](const Figure& figure)
    { return figure.measured && !request.measure ? 1 : figure.seconds; };
    double all = 0;
    for (const Figure& figure : chosen)
    {
        all += secondsOf(figure);
    }

    TaskBar bar;
    double before = 0;
    for (const Figure& figure : chosen)
    {
        if (!arguments.quiet)
        {
            request.say = [&](const std::string& what)
            {
                bar.close();
                say(what + "\n");
            };
            request.progress = [&](std::size_t done, std::size_t parts, const std::string& what)
            {
                const double share = static_cast<double>(done) / static_cast<double>(parts);
                bar.update((before + share * secondsOf(figure)) / all, figure.name, what);
            };
        }
        makeFigure(figure, request);
        before += secondsOf(figure);
    }
    return 0;
}

} // namespace

Command addFiguresCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<FiguresArguments>();
    CLI::App* command = program.add_subcommand(
        "figures", "Make the figures of the documentation: SVG, PNG, data and script");
    command->footer(kExamples);
    std::vector<std::string> names;
    for (const Figure& figure : allFigures())
    {
        names.emplace_back(figure.name);
    }
    command->add_option("--only", arguments->only, "Only these figures; see --list")
        ->delimiter(',')
        ->check(CLI::IsMember(names))
        ->type_name("NAME,...");
    command->add_flag("--list", arguments->list, "List the figures");
    command->add_option("--out", arguments->directory, "Directory of the figures (docs/figures)")
        ->type_name("DIR");
    command->add_flag("--measure", arguments->request.measure,
                      "Measure times again; by default recorded times are drawn");
    command
        ->add_option("--recorded", arguments->recorded,
                     "Directory of the recorded times (docs/figures)")
        ->type_name("DIR");
    command->add_flag("--quick", arguments->request.quick,
                      "Few spheres: a preview, not for the documentation");
    command->add_flag("--quiet", arguments->quiet, "Show no progress");
    return [arguments] { return figures(*arguments); };
}

} // namespace frostfill

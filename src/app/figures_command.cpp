// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "study/figures/figure.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <span>

namespace frostfill
{
namespace
{

constexpr const char* kFiguresExamples = R"(Examples:
  frostfill figures                          all figures into docs/figures, with recorded times
  frostfill figures --measure                with new times; use an idle machine
  frostfill figures --only operations --out output/figures
  frostfill figures --object bunny.obj --out output/bunny
                                             stages, cutaways, discards and volume of one object
)";

struct FiguresArguments
{
    std::vector<std::string> only;
    FigureRequest request;
    std::string directory; ///< empty: the one of the documentation, or of the object
    std::string recorded = "docs/figures";
    bool list = false;
    bool quiet = false;

    [[nodiscard]] std::span<const Figure> figures() const
    {
        return request.object.empty() ? allFigures() : objectFigures();
    }
};

/// Where figures go if the user does not say.
std::string usualDirectory(const std::string& object)
{
    return object.empty() ? "docs/figures"
                          : "output/figures-" + std::filesystem::path(object).stem().string();
}

/// Throws Error usage for a name that is no figure of these.
void checkNames(const FiguresArguments& arguments)
{
    const auto figures = arguments.figures();
    for (const std::string& name : arguments.only)
    {
        if (std::none_of(figures.begin(), figures.end(),
                         [&](const Figure& figure) { return figure.name == name; }))
        {
            throw Error(ErrorCode::usage,
                        fmt::format("there is no figure '{}'; figures{} --list names them", name,
                                    arguments.request.object.empty() ? "" : " --object"));
        }
    }
}

int listFigures(std::span<const Figure> figures)
{
    for (const Figure& figure : figures)
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

/// Whether times of a figure were measured before: its files begin with its name.
bool isRecorded(const Figure& figure, const std::filesystem::path& folder)
{
    std::error_code none;
    const std::filesystem::directory_iterator files(folder, none);
    return std::any_of(begin(files), end(files),
                       [&](const std::filesystem::directory_entry& file)
                       {
                           return file.path().filename().string().starts_with(figure.name) &&
                                  file.path().extension() == ".csv";
                       });
}

/// Names the figures that are measured because no times are recorded, and how long that takes.
void sayWhatIsMeasured(const std::vector<Figure>& chosen, const FigureRequest& request)
{
    std::string names;
    double seconds = 0;
    for (const Figure& figure : chosen)
    {
        if (figure.measured && !request.measure && !isRecorded(figure, request.recorded))
        {
            names += (names.empty() ? "" : ", ") + std::string(figure.name);
            seconds += figure.seconds;
        }
    }
    if (!names.empty() && !request.quick)
    {
        say(fmt::format("{} has no recorded times: these are measured, which takes {:.0f} minutes "
                        "or more: {}\n",
                        request.recorded.string(), std::ceil(seconds / 60), names));
    }
}

int figures(FiguresArguments& arguments)
{
    if (arguments.list)
    {
        return listFigures(arguments.figures());
    }
    checkNames(arguments);
    FigureRequest& request = arguments.request;
    request.directory =
        arguments.directory.empty() ? usualDirectory(request.object) : arguments.directory;
    request.pdf = request.pdf || !request.object.empty();
    request.recorded = arguments.recorded;
    std::vector<Figure> chosen;
    std::copy_if(arguments.figures().begin(), arguments.figures().end(), std::back_inserter(chosen),
                 [&](const Figure& figure) { return wanted(arguments, figure); });
    const auto secondsOf = [&](const Figure& figure)
    {
        return figure.measured && !request.measure && isRecorded(figure, request.recorded)
                   ? 1
                   : figure.seconds;
    };
    if (!arguments.quiet)
    {
        sayWhatIsMeasured(chosen, request);
    }
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
    command->footer(kFiguresExamples);
    command->add_option("--only", arguments->only, "Only these figures; see --list")
        ->delimiter(',')
        ->type_name("NAME,...");
    command
        ->add_option("--object", arguments->request.object,
                     "Figures of this object, a built-in mesh or a file, with PDF")
        ->type_name("MESH");
    command->add_flag("--pdf", arguments->request.pdf, "Draw PDF beside SVG and PNG");
    command->add_flag("--list", arguments->list, "List the figures");
    command
        ->add_option("--out", arguments->directory,
                     "Directory of the figures (docs/figures, or output/figures-OBJECT)")
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

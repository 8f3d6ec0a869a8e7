// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/progress/message.hpp"
#include "app/scene_options.hpp"
#include "fps/fps_compare.hpp"
#include "fps/fps_report.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>

namespace frostfill
{
namespace
{

constexpr const char* kFpsExamples = R"(Examples:
  frostfill fps                                 the four objects, the paper's times beside ours
  frostfill fps torus --searches loop,tree --no-render
  frostfill fps --json > before.json            a baseline for --compare
  frostfill fps --compare before.json           exit code 2 if anything takes 15 % longer
)";

/// Spheres in a group, if the scene does not say.
constexpr std::uint32_t kGroupSize = 10;

struct FpsArguments
{
    std::vector<std::string> scenes;
    std::vector<std::string> searches;
    std::size_t repeats = 5;
    std::size_t warmUp = 20;
    std::uint64_t count = 0;
    std::string older;
    double threshold = 15;
    bool noRender = false;
    bool markdown = false;
    bool csv = false;
    bool json = false;
    bool quiet = false;
    GivenOptions given;
};

Scene sceneOf(const std::string& name, std::uint64_t count, const GivenOptions& given)
{
    Scene scene = name.ends_with(".toml") ? loadScene(name) : presetScene(Preset::paper, name);
    if (scene.spheres.groupSize == 0)
    {
        scene.spheres.groupSize = kGroupSize;
    }
    if (count > 0)
    {
        scene.spheres.count = count;
    }
    applyGivenOptions(given, scene);
    (void)impliesJointRest(given, scene);
    return scene;
}

FpsRequest requestOf(const FpsArguments& arguments)
{
    FpsRequest request;
    const std::vector<std::string> all = builtInMeshNames();
    for (const std::string& name : arguments.scenes.empty() ? all : arguments.scenes)
    {
        request.scenes.push_back(sceneOf(name, arguments.count, arguments.given));
    }
    if (!arguments.searches.empty())
    {
        std::erase_if(request.methods,
                      [&](FpsMethod method)
                      {
                          return std::find(arguments.searches.begin(), arguments.searches.end(),
                                           methodName(method)) == arguments.searches.end();
                      });
    }
    request.repeats = arguments.repeats;
    request.warmUpSteps = arguments.warmUp;
    request.pictures = !arguments.noRender;
    return request;
}

nlohmann::ordered_json readOlder(const std::string& file)
{
    std::ifstream in(file);
    if (!in)
    {
        throw Error(ErrorCode::inputMissing, fmt::format("cannot read {}", file));
    }
    auto older = nlohmann::ordered_json::parse(in, nullptr, false);
    if (!older.is_object())
    {
        throw Error(ErrorCode::badData,
                    fmt::format("{} was not written by frostfill fps --json", file));
    }
    return older;
}

void print(const FpsArguments& arguments, const FpsResult& result,
           const nlohmann::ordered_json& json)
{
    if (arguments.json)
    {
        fmt::print("{}\n", json.dump(2));
        return;
    }
    if (arguments.csv)
    {
        fmt::print("{}", formatCsv(fpsSetTable(result)));
        return;
    }
    for (const Table& table : fpsTables(result))
    {
        fmt::print("{}\n", arguments.markdown ? formatMarkdown(table) : formatText(table));
    }
    fmt::print("{}", fpsCircumstances(result));
}

/// Returns the exit code.
int printComparison(const FpsComparison& comparison, double threshold, bool onStandardOutput)
{
    Table table;
    table.title =
        fmt::format("Compared with the baseline: mean of the fastest run, ms per frame; a "
                    "regression is more than {:g} %",
                    threshold);
    table.words = 3;
    table.headings = {"object", "search", "quantity", "before", "now", "change %", ""};
    for (const FpsChange& change : comparison.changes)
    {
        table.rows.push_back(
            {change.object, change.search, change.quantity.substr(0, change.quantity.find("_ms")),
             fmt::format("{:.4f}", change.before), fmt::format("{:.4f}", change.now),
             fmt::format("{:+.1f}", change.percent()), change.regressed ? "regressed" : ""});
    }
    std::string text = formatText(table);
    if (!comparison.sameMachine)
    {
        text += "the baseline is from another machine, which may explain the difference\n";
    }
    if (onStandardOutput)
    {
        fmt::print("\n{}", text);
    }
    else
    {
        say(text);
    }
    return comparison.regressed() ? static_cast<int>(ErrorCode::thresholdFailed) : 0;
}

int fps(const FpsArguments& arguments)
{
    // Read the baseline first, so an unusable one is reported before the measurement.
    nlohmann::ordered_json older;
    if (!arguments.older.empty())
    {
        older = readOlder(arguments.older);
    }
    const FpsResult result = measureFps(requestOf(arguments),
                                        [&](const std::string& what)
                                        {
                                            if (!arguments.quiet)
                                            {
                                                say(what + "\n");
                                            }
                                        });
    const nlohmann::ordered_json json = fpsJson(result);
    print(arguments, result, json);
    if (arguments.older.empty())
    {
        return 0;
    }
    const FpsComparison comparison = compareFps(older, json, arguments.threshold, arguments.older);
    return printComparison(comparison, arguments.threshold, !arguments.json && !arguments.csv);
}

void addOutputOptions(CLI::App& command, FpsArguments& arguments)
{
    const char* output = "Output";
    CLI::Option* markdown =
        command.add_flag("--markdown", arguments.markdown, "Tables in Markdown")->group(output);
    CLI::Option* csv =
        command.add_flag("--csv", arguments.csv, "CSV with one row for each set")->group(output);
    CLI::Option* json =
        command.add_flag("--json", arguments.json, "One JSON document with all results")
            ->group(output);
    markdown->excludes(csv)->excludes(json);
    csv->excludes(json);
    command.add_flag("--quiet", arguments.quiet, "Show no progress")->group(output);
    command
        .add_option("--compare", arguments.older,
                    "Compare with an earlier --json; exit code 2 for a regression")
        ->type_name("FILE")
        ->group(output);
    command
        .add_option("--threshold", arguments.threshold,
                    "Largest increase that is no regression [%] (15)")
        ->check(CLI::Range(0.0, 1e6))
        ->type_name("PERCENT")
        ->group(output);
}

} // namespace

Command addFpsCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<FpsArguments>();
    CLI::App* command = program.add_subcommand(
        "fps", "Measure frames per second as the paper does, beside its figures");
    command->footer(kFpsExamples);
    command->add_option("SCENE", arguments->scenes,
                        "torus, sphere, cube, human, mesh files or scenes (TOML); by default the "
                        "four objects");
    const char* measurement = "Measurement";
    std::vector<std::string> names;
    for (const FpsMethod method : kFpsMethods)
    {
        names.emplace_back(methodName(method));
    }
    command
        ->add_option("--searches", arguments->searches, "Any of loop, list, tree, grid, fast (all)")
        ->delimiter(',')
        ->check(CLI::IsMember(names))
        ->type_name("A,B,...")
        ->group(measurement);
    command->add_option("--repeats", arguments->repeats, "Runs of each search (5)")
        ->check(CLI::Range(1, 1000))
        ->type_name("N")
        ->group(measurement);
    command
        ->add_option("--warm-up", arguments->warmUp,
                     "Frames left out at the start of each run (20)")
        ->check(CLI::Range(0, 1000000))
        ->type_name("N")
        ->group(measurement);
    command->add_option("--count", arguments->count, "Number of spheres, in place of the scene's")
        ->check(CLI::Range(1, 1000000))
        ->type_name("N")
        ->group(measurement);
    command->add_flag("--no-render", arguments->noRender, "Draw nothing")->group(measurement);
    addSceneOptions(*command, arguments->given);
    addOutputOptions(*command, *arguments);
    return [arguments] { return fps(*arguments); };
}

} // namespace frostfill

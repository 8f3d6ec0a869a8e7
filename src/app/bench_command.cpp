// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/progress/message.hpp"
#include "app/progress/progress.hpp"
#include "study/error/closed_forms.hpp"
#include "study/error/error_study.hpp"
#include "study/figures/all_figures.hpp"
#include "study/operations/operations_study.hpp"
#include "study/operations/triangle_growth.hpp"
#include "study/peers/peer_study.hpp"
#include "study/stability/stability_study.hpp"
#include "study/table.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace frostfill
{
namespace
{

constexpr const char* kBenchExamples = R"(Examples:
  frostfill bench operations                counted tests against the paper's lemmas
  frostfill bench operations --quick --out output/bench
  frostfill bench growth                    cost against the number of triangles
  frostfill bench error                     run time against error
  frostfill bench error --peers             other engines on the same spheres
  frostfill bench error --peer Jolt=./jolt.mjs
  frostfill bench stability                 extreme scenes, both methods
)";

constexpr std::uint64_t kGroups = 200;
constexpr std::uint64_t kQuickGroups = 20;
constexpr double kMinPeerRatio = 50; // claimed: time of the fastest other engine over ours
constexpr double kMaxPower = 1.15;   // claimed: no cost grows by more than this power of triangles
constexpr double kMaxOverlap = 1e-7; // claimed: of our spheres at rest [r]
constexpr double kMaxUnbalanced = 0.005; // claimed: of those that have settled together

struct BenchArguments
{
    bool quick = false;
    bool peers = false;
    std::vector<std::string> programs; ///< engines that are not built in, each NAME=PROGRAM
    std::vector<std::string> objects;  ///< mesh files, beside the four that are built in
    std::string directory = "output/bench";
    int (*run)(const BenchArguments&) = nullptr;
};

/// Lemma 1 has one group in a set, Lemma 2 several. Lemma 3 is checked with both.
std::vector<OperationsCase> operationsCases(bool quick)
{
    std::vector<OperationsCase> cases;
    for (const std::uint64_t k : {1, 4})
    {
        for (const bool discards : {false, true})
        {
            cases.push_back({.object = "torus",
                             .gamma = 10,
                             .k = k,
                             .discards = discards,
                             .groups = quick ? kQuickGroups : kGroups,
                             .room = kGroups});
        }
    }
    return cases;
}

void writeTable(const BenchArguments& arguments, const char* name, const Table& table)
{
    saveCsv(table, std::filesystem::path(arguments.directory) / name);
}

int benchOperations(const BenchArguments& arguments)
{
    std::vector<OperationsResult> results;
    for (const OperationsCase& what : operationsCases(arguments.quick))
    {
        results.push_back(measureOperations(what));
        fmt::print("{}\n", formatText(operationsTable(results.back())));
    }
    writeTable(arguments, "operations.csv", operationsCsv(results));

    std::size_t sets = 0;
    std::size_t apart = 0;
    for (const OperationsResult& result : results)
    {
        sets += result.rows.size();
        apart += static_cast<std::size_t>(std::count_if(result.rows.begin(), result.rows.end(),
                                                        [](const OperationsRow& row)
                                                        { return !row.agrees(); }));
    }
    fmt::print("{} sets; all rows are in {}/operations.csv\n", sets, arguments.directory);
    if (apart > 0)
    {
        fmt::print("verdict: {} sets disagree with the lemmas\n", apart);
        return static_cast<int>(ErrorCode::thresholdFailed);
    }
    fmt::print("verdict: tests equal the lemmas at every set, and responses stay within them\n");
    return 0;
}

/// Without gnuplot there is no figure, and that is no failure.
void draw(const BenchArguments& arguments, const Figure& figure)
{
    FigureRequest request;
    request.directory = arguments.directory;
    try
    {
        drawFigure(figure, request);
        fmt::print("figure: {}/{}.svg\n\n", arguments.directory, figure.name);
    }
    catch (const Error& error)
    {
        if (error.code() != ErrorCode::missingProgram)
        {
            throw;
        }
        say(fmt::format("no figure: {}\n", error.what()));
    }
}

int benchGrowth(const BenchArguments& arguments)
{
    TaskBar bar;
    const std::vector<TriangleGrowthPoint> points = measureTriangleGrowth(
        arguments.quick, [&](std::size_t done, std::size_t all, const std::string& what)
        { bar.update(done, all, what); });
    bar.close();
    writeTable(arguments, "triangles.csv", triangleGrowthCsv(points));
    draw(arguments, trianglesFigure());
    fmt::print("{}\n", formatText(triangleGrowthTable(points)));
    bool holds = true;
    for (const TriangleGrowth& growth : triangleGrowth(points))
    {
        fmt::print("{} grows as triangles^{:.2f}\n", growth.cost, growth.power);
        holds = holds && growth.power <= kMaxPower;
    }
    fmt::print("verdict: {}\n", holds ? "no cost grows faster than the triangles"
                                      : "a cost grows faster than the triangles");
    return holds ? 0 : static_cast<int>(ErrorCode::thresholdFailed);
}

int benchStability(const BenchArguments& arguments)
{
    TaskBar bar;
    const std::vector<StabilityResult> results = measureStability(
        arguments.quick, [&](std::size_t done, std::size_t all, const std::string& what)
        { bar.update(done, all, what); });
    bar.close();
    writeTable(arguments, "stability.csv", stabilityCsv(results));
    draw(arguments, stabilityFigure());
    fmt::print("{}\n", formatText(stabilityTable(results)));
    for (const Preset preset : {Preset::paper, Preset::fast})
    {
        if (const Table unsound = unsoundTable(results, preset); !unsound.rows.empty())
        {
            fmt::print("{}\n", formatText(unsound));
        }
    }
    const bool sound = unsoundTable(results, Preset::fast).rows.empty();
    fmt::print("verdict: the preset fast {}\n",
               sound ? "passes every cell that makes sense and gives a reason for each refusal"
                     : "fails cells of the matrix");
    return sound ? 0 : static_cast<int>(ErrorCode::thresholdFailed);
}

/// Which claims about errors do not hold, a line each.
std::vector<std::string> brokenClaims(const std::vector<ClosedFormPoint>& closed,
                                      const std::vector<ErrorPoint>& points)
{
    std::vector<std::string> broken;
    for (const ClosedFormPoint& point : closed)
    {
        if (!point.holds())
        {
            broken.push_back(fmt::format("{}, {}, {} {:g}: error {:.2e}, but {:.2e} is claimed",
                                         point.problem, point.method, point.parameter, point.value,
                                         point.error, point.expected));
        }
    }
    for (const ErrorPoint& point : points)
    {
        if (point.study == "discards" && point.curve == "exact" && point.error != 0)
        {
            broken.push_back(fmt::format("{}: exact discards change the result", point.setting));
        }
        if (point.study == "rest" && point.curve == "joint" && point.error > kMaxUnbalanced)
        {
            broken.push_back(fmt::format("{}, {}: {:.1f} % of what has settled together do not "
                                         "stay where they are",
                                         point.setting, point.rivals, 100 * point.error));
        }
    }
    return broken;
}

/// Other engines beside ours: what is claimed and does not hold.
void comparePeers(const BenchArguments& arguments, const std::vector<ProgramPeer>& programs,
                  std::vector<std::string>& broken)
{
    TaskBar bar;
    const std::vector<PeerPoint> points =
        measurePeers(arguments.quick, programs,
                     [&](std::size_t done, std::size_t all, const std::string& what)
                     { bar.update(done, all, what); });
    bar.close();
    writeTable(arguments, "peers.csv", peersCsv(points));
    fmt::print("{}\n", formatText(peersTable(points)));
    draw(arguments, peersFigure());
    for (const char* motion : {"fall", "skip", "descend"})
    {
        fmt::print("the fastest other engine takes {:.0f} times as long as --motion {}\n",
                   peerRatio(points, motion), motion);
    }
    fmt::print("\n");
    const double ratio = peerRatio(points, "skip");
    if (!arguments.quick && ratio < kMinPeerRatio)
    {
        broken.push_back(fmt::format("{:.0f} times as fast as the fastest other engine, but {:.0f} "
                                     "times is claimed",
                                     ratio, kMinPeerRatio));
    }
    for (const PeerPoint& point : points)
    {
        if (point.ours && (point.missing + point.outside > 0 || point.worst() > kMaxOverlap))
        {
            broken.push_back(fmt::format("ours, {}: {} lost or outside, overlap {:.1e}",
                                         point.setting, point.missing + point.outside,
                                         point.worst()));
        }
    }
}

int benchError(const BenchArguments& arguments)
{
    const std::vector<ProgramPeer> programs = readProgramPeers(arguments.programs);
    const bool comparesPeers = arguments.peers || !programs.empty();
    if (comparesPeers)
    {
        requirePeers(programs);
    }
    TaskBar bar;
    const std::vector<ErrorPoint> points = // reads the objects first, which may be missing
        measureErrors(arguments.quick, arguments.objects,
                      [&](std::size_t done, std::size_t all, const std::string& what)
                      { bar.update(done, all, what); });
    bar.close();
    const std::vector<ClosedFormPoint> closed = measureClosedForms(arguments.quick);
    writeTable(arguments, "closed-forms.csv", closedFormsCsv(closed));
    fmt::print("{}\n", formatText(closedFormsTable(closed)));
    for (const ErrorStudyInfo& study : errorStudies())
    {
        writeTable(arguments, fmt::format("error-{}.csv", study.name).c_str(),
                   errorCsv(points, study));
        fmt::print("{}\n", formatText(errorTable(points, study)));
    }
    draw(arguments, closedFormsFigure());
    draw(arguments, errorFigure());
    std::vector<std::string> broken = brokenClaims(closed, points);
    if (comparesPeers)
    {
        comparePeers(arguments, programs, broken);
    }
    for (const std::string& claim : broken)
    {
        fmt::print("{}\n", claim);
    }
    fmt::print("verdict: {}\n", broken.empty() ? "errors are as claimed" : "claims do not hold");
    return broken.empty() ? 0 : static_cast<int>(ErrorCode::thresholdFailed);
}

} // namespace

Command addBenchCommand(CLI::App& program)
{
    struct Named
    {
        const char* name;
        const char* text;
        const char* quick;
        int (*run)(const BenchArguments&);
    };
    static constexpr Named kBenches[] = {
        {"operations", "Tests and responses against the paper's Lemmas 1, 2 and 3",
         "20 groups instead of 200", benchOperations},
        {"growth", "Cost of loading, of a sphere and of a picture against the number of triangles",
         "Up to 10,000 triangles instead of 4,000,000; takes some seconds", benchGrowth},
        {"error", "Run time against error, and errors against closed forms",
         "Few spheres and settings; takes less than a minute", benchError},
        {"stability", "A matrix of extreme scenes, each with a verdict",
         "Without the long cells; takes less than a minute", benchStability},
    };
    const auto arguments = std::make_shared<BenchArguments>();
    CLI::App* command =
        program.add_subcommand("bench", "Measure one claim and report whether it holds");
    command->footer(kBenchExamples);
    command->require_subcommand(1);
    for (const Named& bench : kBenches)
    {
        CLI::App* one = command->add_subcommand(bench.name, bench.text);
        one->footer(kBenchExamples);
        one->add_flag("--quick", arguments->quick, bench.quick);
        one->add_option("--out", arguments->directory, "Directory of the results (output/bench)")
            ->type_name("DIR");
        if (bench.run == benchError)
        {
            one->add_flag("--peers", arguments->peers,
                          "Also run other engines on the same spheres (Bullet, ODE, LIGGGHTS)");
            one->add_option("--peer", arguments->programs,
                            "Also run this program, an engine by its path; may be repeated")
                ->type_name("NAME=PROGRAM");
            one->add_option("--object", arguments->objects,
                            "Also estimate the volume of this mesh; may be repeated")
                ->type_name("FILE");
        }
        one->parse_complete_callback([arguments, &bench] { arguments->run = bench.run; });
    }
    return [arguments] { return arguments->run(*arguments); };
}

} // namespace frostfill

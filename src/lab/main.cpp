// SPDX-License-Identifier: MIT
#include "lab/closed_forms.hpp"
#include "lab/operations.hpp"
#include "lab/study.hpp"
#include "lab/triangle_growth.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace
{

using namespace frostfill;

constexpr const char* kExamples = R"(Examples:
  frostfill-lab operations            counted tests against the paper's lemmas
  frostfill-lab closed-forms          errors against closed forms
  frostfill-lab claim --quick         a look, with few spheres
  frostfill-lab peers --peer Jolt=examples/peers/jolt.mjs
  scripts/figures --measure           every table, and the figures drawn from them
)";

constexpr std::size_t kMostShown = 120; // rows of a table
constexpr std::uint64_t kGroups = 200;
constexpr std::uint64_t kQuickGroups = 20;
constexpr double kMinPeerRatio = 50; // claimed: time of the fastest other engine over ours
constexpr double kMaxPower = 1.15;   // claimed: no cost grows by more than this power of triangles
constexpr double kMaxOverlap = 1e-7; // claimed: of our spheres at rest [r]
constexpr double kMaxUnbalanced = 0.005; // claimed: of those that have settled together

struct LabRequest
{
    bool quick = false;
    std::vector<std::string> engines; ///< each NAME=PROGRAM
    std::filesystem::path folder = "output/lab";

    /// And shows it, if it is short.
    void write(const std::string& name, Table table) const
    {
        saveCsv(table, folder / name);
        table.title = (folder / name).string();
        fmt::print("{}\n", table.rows.size() > kMostShown ? table.title : formatText(table));
    }
    [[nodiscard]] std::vector<ProgramPeer> peers() const
    {
        std::vector<ProgramPeer> read = readProgramPeers(engines);
        std::for_each(read.begin(), read.end(), tryProgramPeer);
        return read;
    }
};

void tell(std::size_t done, std::size_t all, const std::string& what)
{
    fmt::print(stderr, "{}/{} {}\n", done, all, what);
}

/// Prints what does not hold, or that all does. Returns the exit code.
int verdict(const std::vector<std::string>& broken, const char* holds)
{
    for (const std::string& claim : broken)
    {
        fmt::print("{}\n", claim);
    }
    fmt::print("verdict: {}\n", broken.empty() ? holds : "claims do not hold");
    return broken.empty() ? 0 : static_cast<int>(ErrorCode::thresholdFailed);
}

/// Lemma 1 has one group in a set, Lemma 2 several. Lemma 3 is checked with both. The figure shows
/// the first two.
int operations(const LabRequest& request)
{
    std::vector<OperationsResult> results;
    std::vector<std::string> broken;
    for (const std::uint64_t k : {1, 4})
    {
        for (const bool discards : {false, true})
        {
            results.push_back(measureOperations({.object = "torus",
                                                 .gamma = 10,
                                                 .k = k,
                                                 .discards = discards,
                                                 .groups = request.quick ? kQuickGroups : kGroups,
                                                 .room = kGroups}));
            for (const OperationsRow& row : results.back().rows)
            {
                if (!row.agrees())
                {
                    broken.push_back(
                        fmt::format("{} groups, {} a set: the lemmas say otherwise", row.beta, k));
                }
            }
        }
    }
    request.write("operations.csv", operationsCsv(results));
    return verdict(broken, "tests equal the lemmas at every set, and responses stay within them");
}

int triangles(const LabRequest& request)
{
    const std::vector<TriangleGrowthPoint> points = measureTriangleGrowth(request.quick, tell);
    request.write("triangles.csv", triangleGrowthCsv(points));
    std::vector<std::string> broken;
    for (const TriangleGrowth& growth : triangleGrowth(points))
    {
        fmt::print("{} grows as triangles^{:.2f}\n", growth.cost, growth.power);
        if (growth.power > kMaxPower)
        {
            broken.push_back(fmt::format("{} grows faster than the triangles", growth.cost));
        }
    }
    return verdict(broken, "no cost grows faster than the triangles");
}

int closedForms(const LabRequest& request)
{
    const std::vector<ClosedFormPoint> points = measureClosedForms(request.quick);
    request.write("closed-forms.csv", closedFormsCsv(points));
    std::vector<std::string> broken;
    for (const ClosedFormPoint& point : points)
    {
        if (!point.holds())
        {
            broken.push_back(fmt::format("{}, {}, {} {:g}: error {:.2e}, but {:.2e} is claimed",
                                         point.problem, point.method, point.parameter, point.value,
                                         point.error, point.expected));
        }
    }
    return verdict(broken, "errors are as claimed");
}

int claim(const LabRequest& request)
{
    request.write("claim.csv", measureClaim(request.quick, tell));
    return 0;
}

int times(const LabRequest& request)
{
    const TimesTables tables = measureTimes(request.quick, tell);
    request.write("times.csv", tables.times);
    request.write("fps.csv", tables.sets);
    saveText(tables.markdown, request.folder / "fps.md");
    return 0;
}

int rest(const LabRequest& request)
{
    const std::vector<RestPoint> points = measureRest(request.quick, request.peers(), tell);
    request.write("error-rest.csv", restCsv(points));
    std::vector<std::string> broken;
    for (const RestPoint& point : points)
    {
        if (point.curve == "joint" && point.unbalanced > kMaxUnbalanced)
        {
            broken.push_back(fmt::format("{}, friction {:g}: {:.1f} % of what has settled together "
                                         "do not stay where they are",
                                         point.setting, point.friction, 100 * point.unbalanced));
        }
    }
    return verdict(broken, "what settles together stays where it is");
}

int peers(const LabRequest& request)
{
    const std::vector<ProgramPeer> engines = request.peers();
    if (engines.empty())
    {
        throw Error(ErrorCode::usage, "name an engine by --peer NAME=PROGRAM; see examples/peers");
    }
    const std::vector<PeerPoint> points = measurePeers(request.quick, engines, tell);
    request.write("peers.csv", peersCsv(points));
    for (const char* motion : {"fall", "skip", "descend"})
    {
        fmt::print("the fastest other engine takes {:.0f} times as long as --motion {}\n",
                   peerRatio(points, motion), motion);
    }
    std::vector<std::string> broken;
    if (const double ratio = peerRatio(points, "skip"); !request.quick && ratio < kMinPeerRatio)
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
    return verdict(broken, "ours is as fast and as exact as claimed");
}

struct LabCommand
{
    const char* name;
    const char* text;
    int (*run)(const LabRequest&);
    bool takesPeers = false;
};
constexpr LabCommand kLabCommands[] = {
    {"closed-forms", "Errors against closed forms", closedForms},
    {"operations", "Tests and responses against the paper's Lemmas 1, 2 and 3", operations},
    {"claim", "Cost of a frame and of a sphere while the torus fills", claim},
    {"times", "The paper's times beside ours, as `frostfill fps` measures them", times},
    {"triangles", "Cost of loading, of a sphere and of a picture against the triangles", triangles},
    {"rest", "Run time against the share of spheres that nothing holds", rest, true},
    {"peers", "Other engines on the same spheres", peers, true},
};

int runLab(int argumentCount, char** arguments)
{
    CLI::App program("Measures the claims of the documentation of Frostfill.", "frostfill-lab");
    program.footer(kExamples);
    program.require_subcommand(1);
    LabRequest request;
    int (*chosen)(const LabRequest&) = nullptr;
    for (const LabCommand& each : kLabCommands)
    {
        CLI::App* command = program.add_subcommand(each.name, each.text);
        command->add_flag("--quick", request.quick, "Few spheres: a look, not a measurement");
        command->add_option("--out", request.folder, "Folder of the tables (output/lab)")
            ->type_name("DIR");
        if (each.takesPeers)
        {
            command
                ->add_option("--peer", request.engines,
                             "Another engine, by its program; may be repeated")
                ->type_name("NAME=PROGRAM");
        }
        command->parse_complete_callback([&chosen, run = each.run] { chosen = run; });
    }
    try
    {
        program.parse(argumentCount, arguments);
    }
    catch (const CLI::ParseError& error)
    {
        return program.exit(error) == 0 ? 0 : static_cast<int>(ErrorCode::usage);
    }
    return chosen(request);
}

} // namespace

int main(int argumentCount, char** arguments)
{
    try
    {
        return runLab(argumentCount, arguments);
    }
    catch (const Error& error)
    {
        fmt::print(stderr, "frostfill-lab: {}\n", error.what());
        return static_cast<int>(error.code());
    }
    catch (const std::exception& error)
    {
        fmt::print(stderr, "frostfill-lab: {}\n", error.what());
        return static_cast<int>(ErrorCode::postcondition);
    }
}

// SPDX-License-Identifier: MIT
#include "app/commands.hpp"
#include "app/say.hpp"

#include "output/atomic_file.hpp"
#include "study/operations_study.hpp"

#include <frostfill/error.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace frostfill
{
namespace
{

constexpr const char* kExamples = R"(Examples:
  frostfill bench operations                the paper's lemmas against what is counted
  frostfill bench operations --quick --out output/bench
)";

constexpr std::uint64_t kGroups = 200;
constexpr std::uint64_t kQuickGroups = 20;

struct BenchArguments
{
    bool quick = false;
    std::string directory = "output/bench";
};

/// Lemma 1 has one group a set, Lemma 2 several; Lemma 3 is looked at with both.
std::vector<OperationsCase> operationsCases(bool quick)
{
    std::vector<OperationsCase> cases;
    for (const std::uint64_t k : {1, 4})
        for (const bool discards : {false, true})
            cases.push_back({.object = "torus",
                             .gamma = 10,
                             .k = k,
                             .discards = discards,
                             .groups = quick ? kQuickGroups : kGroups});
    return cases;
}

int benchOperations(const BenchArguments& arguments)
{
    std::vector<OperationsResult> results;
    for (const OperationsCase& what : operationsCases(arguments.quick))
    {
        results.push_back(measureOperations(what));
        fmt::print("{}\n", formatText(operationsTable(results.back())));
    }
    createDirectory(arguments.directory);
    const auto file = std::filesystem::path(arguments.directory) / "operations.csv";
    AtomicFile out(file);
    out.write(formatCsv(operationsCsv(results)));
    out.commit();

    std::size_t sets = 0;
    std::size_t apart = 0;
    for (const OperationsResult& result : results)
    {
        sets += result.rows.size();
        apart += static_cast<std::size_t>(std::count_if(result.rows.begin(), result.rows.end(),
                                                        [](const OperationsRow& row)
                                                        { return !row.agrees(); }));
    }
    fmt::print("{} sets, every row in {}\n", sets, file.string());
    if (apart > 0)
    {
        fmt::print("verdict: {} sets do not agree with the lemmas\n", apart);
        return static_cast<int>(ErrorCode::thresholdFailed);
    }
    fmt::print("verdict: tests equal the lemmas' at every set, and responses stay within them\n");
    return 0;
}

} // namespace

Command addBenchCommand(CLI::App& program)
{
    const auto arguments = std::make_shared<BenchArguments>();
    CLI::App* command =
        program.add_subcommand("bench", "Measure one claim and say whether it holds");
    command->footer(kExamples);
    command->require_subcommand(1);
    CLI::App* operations = command->add_subcommand(
        "operations", "Tests and responses against the paper's Lemmas 1, 2 and 3");
    operations->footer(kExamples);
    operations->add_flag("--quick", arguments->quick, "20 groups instead of 200");
    operations
        ->add_option("--out", arguments->directory, "Directory of operations.csv (output/bench)")
        ->type_name("DIR");
    return [arguments] { return benchOperations(*arguments); };
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "study/figures/all_figures.hpp"
#include "study/figures/embedded_scripts.hpp"
#include "study/operations/operations_study.hpp"

namespace frostfill
{
namespace
{

constexpr std::uint64_t kGroups = 200;
constexpr std::uint64_t kQuickGroups = 20;

void makeOperationsData(const FigureFolder& folder)
{
    std::vector<OperationsResult> results;
    for (const bool discards : {false, true})
    {
        results.push_back(measureOperations({.object = "torus",
                                             .gamma = 10,
                                             .k = 1,
                                             .discards = discards,
                                             .groups = folder.quick() ? kQuickGroups : kGroups}));
    }
    folder.write("operations.csv", operationsCsv(results));
}

} // namespace

Figure operationsFigure()
{
    return {"operations",
            "operations against spheres: the lemmas and what is counted",
            false,
            5,
            makeOperationsData,
            embedded::figure_operations};
}

} // namespace frostfill

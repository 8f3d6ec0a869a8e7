// SPDX-License-Identifier: MIT
// Room: the program frostfill-lab, which measures the claims of the documentation and writes them
// as tables. Users neither build nor install it.
#pragma once

#include "fps/table.hpp"
#include "lab/program_peer.hpp"

#include <functional>
#include <string>
#include <vector>

namespace frostfill
{

/// Hears how far a measurement is: parts done, parts in all, and what has just ended.
using LabProgress = std::function<void(std::size_t, std::size_t, const std::string&)>;

/// One run: what it cost and how wrong it was.
struct ErrorPoint
{
    std::string curve;   ///< the method
    std::string setting; ///< what is varied, and its value
    std::string rivals;  ///< a point competes with those that have the same here
    bool isDefault = false;
    double seconds = 0; ///< of processor time, one thread
    double error = 0;   ///< the study says what it is
    /// More numbers of the same run, named by the study.
    std::vector<double> details;
};

/// A set of runs with one measure of their errors.
struct ErrorStudy
{
    const char* name; ///< its table is error-NAME.csv
    const char* error;
    std::vector<const char*> details;
    std::vector<ErrorPoint> points;

    /// A detail of a point, by name. Throws std::out_of_range.
    [[nodiscard]] double detail(const ErrorPoint& point, const std::string& detailName) const;
};

/// Time steps and contact sweeps against overlap, energy and support, for both presets.
[[nodiscard]] ErrorStudy measureSteps(bool quick, const LabProgress& progress);

/// The share of spheres that nothing holds when all are let go: of spheres that rest each by
/// itself, that have settled together, and that other engines have brought to rest.
[[nodiscard]] ErrorStudy measureRest(bool quick, const std::vector<ProgramPeer>& engines,
                                     const LabProgress& progress);

/// Cost of a step and of a sphere while the torus fills: the tables claim.csv and claim-growth.csv.
struct ClaimTables
{
    Table points;
    Table growth;
};
[[nodiscard]] ClaimTables measureClaim(bool quick, const LabProgress& progress);

/// The measurement of `frostfill fps` for the figure and the page of the documentation.
struct TimesTables
{
    Table times; ///< the paper's and ours, by object and search
    Table sets;  ///< every set
    std::string markdown;
};
[[nodiscard]] TimesTables measureTimes(bool quick, const LabProgress& progress);

[[nodiscard]] Table errorCsv(const ErrorStudy& study);
[[nodiscard]] Table errorTable(const ErrorStudy& study);

} // namespace frostfill

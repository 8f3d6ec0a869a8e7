// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/analysis.hpp>
#include <frostfill/columns.hpp>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace frostfill
{

/// Where the values of a measured column come from.
struct Finding
{
    const char* column;
    std::optional<AnalysisKind> kind; ///< that finds them; none: they are always there
    double (*of)(const PackingAnalysis& analysis, std::size_t k);
};
[[nodiscard]] std::span<const Finding> findings();

/// A value that each sphere of an analysis has.
struct SphereValue
{
    Column column; ///< as declared in the table of columns, but with all digits
    std::function<double(std::size_t k)> of;
};

/// Those of an analysis: place and radius, then what was asked. They read the analysis.
[[nodiscard]] std::vector<SphereValue> sphereValues(const PackingAnalysis& analysis);

} // namespace frostfill

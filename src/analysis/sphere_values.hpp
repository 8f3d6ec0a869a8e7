// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/analysis.hpp>
#include <frostfill/columns.hpp>

#include <functional>
#include <vector>

namespace frostfill
{

/// A value that each sphere of an analysis has.
struct SphereValue
{
    Column column; ///< its name, type, unit and help
    std::function<double(std::size_t k)> of;
};

/// Those of an analysis: place and radius, then what was asked. They read the analysis.
[[nodiscard]] std::vector<SphereValue> sphereValues(const PackingAnalysis& analysis);

} // namespace frostfill

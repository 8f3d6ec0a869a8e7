// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace frostfill
{

[[nodiscard]] double mean(std::span<const double> values);

/// The nearest-rank percentile: the smallest value that `share` (0..1) of all do not exceed.
/// Reorders the values; 0 for none.
[[nodiscard]] double percentile(std::vector<double>& values, double share);

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace frostfill
{

/// What a sample of measurements looks like. All zero for an empty sample.
struct Distribution
{
    std::size_t count = 0;
    double mean = 0;
    double median = 0;
    double p95 = 0; ///< nearest rank: the smallest value that 95 % do not exceed
    double p99 = 0;
    double least = 0;
    double greatest = 0;
};
[[nodiscard]] Distribution describe(std::vector<double> values);

/// Mean of repeated runs, and half the width of its 95 % confidence interval (Student's t). The
/// half-width is 0 for fewer than two values: nothing is known then.
struct RepeatedMean
{
    double mean = 0;
    double halfWidth = 0;
    double least = 0; ///< of the runs: what disturbances have added least to
};
[[nodiscard]] RepeatedMean meanOfRepeats(std::span<const double> runs);

} // namespace frostfill

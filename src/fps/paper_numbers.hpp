// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// A number of the paper, or from where to where it goes.
struct PaperRange
{
    double low = 0;
    double high = 0;
};
/// "23", or "13-25".
[[nodiscard]] std::string rangeText(const PaperRange& range);

/// What the paper reports for one of its objects (section 3.1 and its discussion; two-CPU Xeon at
/// 2.49 GHz): the only numbers in our tables that were typed.
struct PaperNumbers
{
    std::string_view object;
    /// [ms a frame] sphere-polygon work with the plain loop, for each set since the last freezing.
    std::vector<PaperRange> spherePolygonMs;
    double polygonsDiscarded = 0; ///< [%]
    PaperRange treeGainMs;        ///< [ms a frame] that the tree saves
};

/// Null for an object that the paper does not have.
[[nodiscard]] const PaperNumbers* paperNumbers(std::string_view object);

} // namespace frostfill

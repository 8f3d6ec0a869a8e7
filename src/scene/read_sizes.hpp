// SPDX-License-Identifier: MIT
#pragma once

#include "scene/size_curve.hpp"

#include <frostfill/scene.hpp>

#include <string_view>

namespace frostfill
{

/// The ratio of the largest to the smallest radius that a run can do with. [1]
inline constexpr double kLargestSizeRatio = 100;

/// Whether the text is a distribution by its name, or meant as one: "lognormal:2,0.5".
[[nodiscard]] bool isNamedSizes(std::string_view text);

/// The curve of a scene that has one. The file has two columns and a header, such as
/// "diameter,cumulative mass": radius or diameter; share, or cumulative or passing; and number,
/// mass or volume, if `by` does not say it. Shares, which add up to 1 or to 100, are of spheres
/// that all have the size of the row. A cumulative curve begins with 0 and ends with 1 or 100, and
/// is a line from row to row; two rows with one size are spheres that all have it. Sizes ascend or
/// descend. Throws Error inputMissing, badData with the file and the line, or usage for a
/// distribution that cannot be.
[[nodiscard]] SizeCurve readSizeCurve(const SizeSettings& sizes);

/// The part of it that knows formulas.
[[nodiscard]] SizeCurve namedSizes(std::string_view text, int power);

} // namespace frostfill

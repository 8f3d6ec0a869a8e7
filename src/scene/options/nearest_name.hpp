// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace frostfill
{

/// Number of insertions, deletions and substitutions from `a` to `b` [Levenshtein 1966].
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

/// The name with the smallest edit distance from `name`; the first of several. Empty if more than
/// half of `name` would have to change, because that is no typing error.
[[nodiscard]] std::string nearestName(std::string_view name, std::span<const std::string> names);

} // namespace frostfill

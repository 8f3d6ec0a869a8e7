// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/options.hpp>

#include <cstddef>
#include <string_view>

namespace frostfill
{

/// Number of insertions, deletions and substitutions from `a` to `b` [Levenshtein 1966].
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

} // namespace frostfill

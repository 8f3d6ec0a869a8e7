// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace frostfill
{

/// What stands before the values of an array in NumPy's format, version 1.0. `type`: as NumPy
/// writes it, such as <f8. `shape`: the last index runs fastest.
[[nodiscard]] std::string npyHeader(std::string_view type, const std::vector<std::size_t>& shape);

} // namespace frostfill

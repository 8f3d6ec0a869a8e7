// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace frostfill
{

/// What the first line of a size curve says of its columns.
struct SizeHeader
{
    bool isDiameter = false;
    bool isCumulative = false;
    std::optional<SharesOf> by;
    char separator = ',';
};

inline constexpr const char* kSizeHeaderForm =
    "a header names the columns, such as 'diameter,cumulative mass' or 'radius,share'";

/// `refuse` throws for what is wrong, in a sentence.
[[nodiscard]] SizeHeader readSizeHeader(std::string_view text,
                                        const std::function<void(const std::string&)>& refuse);

/// Without spaces and quotation marks around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// As a message has it: a file may hold anything.
[[nodiscard]] std::string shown(std::string_view text);

} // namespace frostfill

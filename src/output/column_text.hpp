// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/columns.hpp>

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>
#include <string>

namespace frostfill
{

/// Calls visit(number) with a value of a column in the column's own type.
template <typename Visit>
void visitNumber(const Column& column, double value, Visit&& visit)
{
    switch (column.type)
    {
    case ColumnType::uint8:
        return visit(static_cast<std::uint8_t>(value));
    case ColumnType::uint32:
        return visit(static_cast<std::uint32_t>(value));
    case ColumnType::float32:
        return visit(static_cast<float>(value));
    case ColumnType::float64:
        break;
    }
    visit(value);
}

/// Appends a value of a column with the digits that read back to the same bits.
inline void putText(fmt::memory_buffer& row, const Column& column, double value)
{
    visitNumber(column, value,
                [&](auto number)
                { fmt::format_to(std::back_inserter(row), FMT_COMPILE("{}"), number); });
}

/// A cell of a table as RFC 4180 has it: quoted where a comma, a quote or a line's end would be
/// read otherwise.
[[nodiscard]] inline std::string csvCell(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
    {
        return text;
    }
    std::string quoted = "\"";
    for (const char letter : text)
    {
        quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    return quoted + "\"";
}

} // namespace frostfill

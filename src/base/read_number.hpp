// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace frostfill
{

/// Returns the number that a whole text is, and nothing for any other text. `base`: for whole
/// numbers, 16 for example.
template <typename Number, typename... Base>
[[nodiscard]] std::optional<Number> readNumber(std::string_view text, Base... base)
{
    Number value{};
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, base...);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                    : std::nullopt;
}

/// Splits a text at each separator. An empty text is one empty part.
[[nodiscard]] inline std::vector<std::string_view> partsOf(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    while (true)
    {
        const std::size_t end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
        {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

/// Reads numbers separated by commas. Returns nothing where one of them is none.
[[nodiscard]] inline std::optional<std::vector<double>> readNumbers(std::string_view text)
{
    std::vector<double> numbers;
    for (const std::string_view part : partsOf(text, ','))
    {
        const auto number = readNumber<double>(part);
        if (!number)
        {
            return std::nullopt;
        }
        numbers.push_back(*number);
    }
    return numbers;
}

} // namespace frostfill

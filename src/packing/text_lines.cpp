// SPDX-License-Identifier: MIT
#include "packing/text_lines.hpp"

#include "base/read_number.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// More than any packing has; a count in a file may be anything.
constexpr std::size_t kMaxSpheres = 1'000'000'000;

std::string_view withoutQuotes(std::string_view word)
{
    const bool quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
    return quoted ? word.substr(1, word.size() - 2) : word;
}

} // namespace

bool TextLines::next(std::string_view& line)
{
    if (rest_.empty())
    {
        return false;
    }
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    cut_ = cut_ || end == rest_.size();
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (!line.empty() && line.back() == '\r')
    {
        line.remove_suffix(1);
    }
    ++line_;
    return true;
}

std::string_view TextLines::need(std::string_view what)
{
    std::string_view line;
    if (!next(line))
    {
        cut_ = true;
        refuse(fmt::format("the file ends before {}", what));
    }
    return line;
}

void TextLines::refuse(std::string_view what) const
{
    throw Error(ErrorCode::badData, fmt::format("{}, line {}: {}", file_, line_, what));
}

std::vector<std::string_view> wordsOf(std::string_view line, char separator)
{
    std::vector<std::string_view> words;
    const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
    std::size_t at = 0;
    while (at < line.size())
    {
        while (at < line.size() && isBlank(line[at]))
        {
            ++at;
        }
        std::size_t end = at;
        while (end < line.size() && (separator != 0 ? line[end] != separator : !isBlank(line[end])))
        {
            ++end;
        }
        std::string_view word = line.substr(at, end - at);
        while (!word.empty() && isBlank(word.back()))
        {
            word.remove_suffix(1);
        }
        if (separator != 0 || !word.empty())
        {
            words.push_back(withoutQuotes(word));
        }
        at = end + (separator != 0 ? 1 : 0);
    }
    return words;
}

double numberOf(std::string_view word, const TextLines& lines)
{
    const auto value = readNumber<double>(word.starts_with('+') ? word.substr(1) : word);
    if (!value)
    {
        lines.refuse(fmt::format("'{}' is no number", word));
    }
    return *value;
}

std::size_t countOf(std::string_view word, const TextLines& lines)
{
    const auto value = readNumber<std::size_t>(word);
    if (!value || *value > kMaxSpheres)
    {
        lines.refuse(fmt::format("'{}' is no number of spheres", word));
    }
    return *value;
}

std::uint64_t wholeNumberOf(std::string_view word, const TextLines& lines)
{
    const auto value = readNumber<std::uint64_t>(word);
    if (!value)
    {
        lines.refuse(fmt::format("'{}' is no whole number from 0", word));
    }
    return *value;
}

} // namespace frostfill

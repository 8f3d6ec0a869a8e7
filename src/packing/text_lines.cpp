// SPDX-License-Identifier: MIT
#include "packing/text_lines.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace frostfill
{
namespace
{

/// More than any packing has; a count in a file may be anything.
constexpr std::size_t kMostSpheres = 1'000'000'000;

std::string lowered(std::string_view word)
{
    std::string low(word);
    std::transform(low.begin(), low.end(), low.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return low;
}

std::string_view withoutQuotes(std::string_view word)
{
    const bool quoted = word.size() >= 2 && word.front() == '"' && word.back() == '"';
    return quoted ? word.substr(1, word.size() - 2) : word;
}

/// "running" or 0 in a file of ours; anything else rests.
bool rests(std::string_view state)
{
    return state != "running" && state != "0";
}

} // namespace

bool TextLines::next(std::string_view& line)
{
    if (rest_.empty())
    {
        return false;
    }
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
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
    double value = 0;
    const std::string_view plain = word.starts_with('+') ? word.substr(1) : word;
    const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
    if (error != std::errc() || end != plain.data() + plain.size())
    {
        lines.refuse(fmt::format("'{}' is no number", word));
    }
    return value;
}

std::size_t countOf(std::string_view word, const TextLines& lines)
{
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || value > kMostSpheres)
    {
        lines.refuse(fmt::format("'{}' is no number of spheres", word));
    }
    return value;
}

void SphereColumns::take(std::string_view name, int index)
{
    const std::string low = lowered(name);
    const auto is = [&](std::initializer_list<const char*> names)
    { return std::find(names.begin(), names.end(), low) != names.end(); };
    int* column = is({"x", "xu", "pos_x", "position_x"})   ? &x
                  : is({"y", "yu", "pos_y", "position_y"}) ? &y
                  : is({"z", "zu", "pos_z", "position_z"}) ? &z
                  : is({"radius", "r", "rad"})             ? &radius
                  : is({"diameter", "d"})                  ? &diameter
                  : is({"state"})                          ? &state
                                                           : nullptr;
    if (column != nullptr && *column < 0)
    {
        *column = index;
    }
}

void SphereColumns::requireAll(const TextLines& lines, double given) const
{
    if (x < 0 || y < 0 || z < 0)
    {
        lines.refuse(fmt::format("no column {}: the columns x, y and z are needed, and radius",
                                 x < 0   ? "x"
                                 : y < 0 ? "y"
                                         : "z"));
    }
    if (radius < 0 && diameter < 0 && given <= 0)
    {
        lines.refuse("no column radius: if all spheres have one radius, give it with --radius");
    }
}

std::size_t SphereColumns::width() const
{
    return static_cast<std::size_t>(std::max({x, y, z, radius, diameter, state})) + 1;
}

void addSphere(const std::vector<std::string_view>& words, const SphereColumns& columns,
               double radius, const TextLines& lines, Packing& packing)
{
    if (words.size() < columns.width())
    {
        lines.refuse(fmt::format("{} values, where {} are needed", words.size(), columns.width()));
    }
    const auto word = [&](int column) { return words[static_cast<std::size_t>(column)]; };
    const auto number = [&](int column) { return numberOf(word(column), lines); };
    packing.centres.emplace_back(number(columns.x), number(columns.y), number(columns.z));
    packing.radii.push_back(columns.radius >= 0     ? number(columns.radius)
                            : columns.diameter >= 0 ? number(columns.diameter) / 2
                                                    : radius);
    packing.atRest.push_back(columns.state < 0 || rests(word(columns.state)));
}

} // namespace frostfill

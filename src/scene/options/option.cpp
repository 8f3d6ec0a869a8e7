// SPDX-License-Identifier: MIT
#include "base/read_number.hpp"
#include "scene/options/nearest_name.hpp"
#include "scene/options/table_builder.hpp"

#include <frostfill/options.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace frostfill
{
namespace
{

std::optional<Eigen::Vector3d> readVector(std::string_view text)
{
    const auto numbers = readNumbers(text);
    return numbers && numbers->size() == 3
               ? std::optional(Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]))
               : std::nullopt;
}

bool inRange(const OptionRange& range, double value)
{
    return std::isfinite(value) && value <= range.high &&
           (range.withoutLow ? value > range.low : value >= range.low);
}

std::string describeRange(const OptionRange& range)
{
    const OptionRange all;
    const std::string low = range.low == all.low ? "" : fmt::format("{}", range.low);
    const std::string high = range.high == all.high ? "" : fmt::format("{}", range.high);
    if (low.empty())
    {
        return high.empty() ? "" : fmt::format(" up to {}", high);
    }
    if (high.empty())
    {
        return range.withoutLow ? fmt::format(" above {}", low)
                                : fmt::format(" of at least {}", low);
    }
    return range.withoutLow ? fmt::format(" above {} and up to {}", low, high)
                            : fmt::format(" from {} to {}", low, high);
}

/// Converts a whole number to a number where one is required, and a word to the number it stands
/// for.
OptionValue converted(const Option& option, OptionValue value)
{
    if (const auto* text = std::get_if<std::string>(&value))
    {
        if (!option.nothing.empty() && *text == option.nothing)
        {
            return std::monostate{};
        }
        for (const auto& [word, number] : option.words)
        {
            if (*text == word)
            {
                return number;
            }
        }
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value);
        whole && (option.type == OptionType::number || option.type == OptionType::radii))
    {
        return static_cast<double>(*whole);
    }
    return value;
}

bool allowed(const Option& option, const OptionValue& value)
{
    if (std::holds_alternative<std::monostate>(value))
    {
        return !option.nothing.empty();
    }
    switch (option.type)
    {
    case OptionType::boolean:
        return std::holds_alternative<bool>(value);
    case OptionType::integer:
        return std::holds_alternative<std::int64_t>(value) &&
               inRange(option.range, static_cast<double>(std::get<std::int64_t>(value)));
    case OptionType::number:
        return std::holds_alternative<double>(value) &&
               inRange(option.range, std::get<double>(value));
    case OptionType::vector:
        return std::holds_alternative<Eigen::Vector3d>(value) &&
               std::get<Eigen::Vector3d>(value).allFinite() &&
               inRange(option.range, std::get<Eigen::Vector3d>(value).minCoeff()) &&
               inRange(option.range, std::get<Eigen::Vector3d>(value).maxCoeff());
    case OptionType::radii:
        return std::holds_alternative<std::string>(value) ||
               (std::holds_alternative<double>(value) &&
                inRange(option.range, std::get<double>(value)));
    case OptionType::text:
        break;
    }
    const auto* text = std::get_if<std::string>(&value);
    const std::vector<std::string>& texts = option.choices;
    return text && (texts.empty() || std::find(texts.begin(), texts.end(), *text) != texts.end());
}

} // namespace

std::span<const Option> sceneOptions()
{
    static const std::vector<Option> kTable = []
    {
        TableBuilder table;
        addRunOptions(table);
        addPictureOptions(table);
        return table.take();
    }();
    return kTable;
}

const Option* findOption(std::string_view key)
{
    for (const Option& option : sceneOptions())
    {
        if (option.key == key)
        {
            return &option;
        }
    }
    return nullptr;
}

std::string didYouMeanKey(std::string_view key)
{
    std::vector<std::string> names;
    for (const Option& option : sceneOptions())
    {
        names.push_back(option.key);
    }
    const std::string nearest = nearestName(key, names);
    return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

const Option& optionOf(std::string_view key)
{
    const Option* found = findOption(key);
    if (found == nullptr)
    {
        throw std::logic_error(fmt::format("there is no option '{}'", key));
    }
    return *found;
}

std::vector<const Option*> optionsFor(OptionUse use)
{
    constexpr std::array<std::string_view, 2> kPictureGroups = {"Pictures", "Camera"};
    constexpr std::array<std::string_view, 3> kOfTheRun = {"frames.slow_motion", "frames.duration",
                                                           "frames.keep_run"};
    constexpr std::array<std::string_view, 4> kLoading = {"object.lid", "object.cavity",
                                                          "object.wrap", "object.unite"};
    const auto isIn = [](const auto& names, const std::string& name)
    { return std::find(names.begin(), names.end(), name) != names.end(); };
    std::vector<const Option*> options;
    for (const Option& option : sceneOptions())
    {
        const bool loads = isIn(kLoading, option.key);
        const bool draws = isIn(kPictureGroups, option.group) && !isIn(kOfTheRun, option.key);
        if (use == OptionUse::filling || (use == OptionUse::pictures && draws) ||
            (use == OptionUse::loading && loads) ||
            (use == OptionUse::judging &&
             (loads || option.key == "object.up" || option.key.starts_with("judge."))))
        {
            options.push_back(&option);
        }
    }
    return options;
}

std::string describeAllowed(const Option& option)
{
    std::string what;
    switch (option.type)
    {
    case OptionType::boolean:
        what = "true or false";
        break;
    case OptionType::integer:
        what = "a whole number" + describeRange(option.range);
        break;
    case OptionType::number:
        what = "a number" + describeRange(option.range);
        break;
    case OptionType::vector:
        what = "three numbers x,y,z" + describeRange(option.range);
        break;
    case OptionType::radii:
        what = "a number" + describeRange(option.range) +
               ", a range such as 0.02..0.05, a file with one radius per line";
        break;
    case OptionType::text:
        what = option.choices.empty() ? option.form
                                      : fmt::format("{}", fmt::join(option.choices, ", "));
        break;
    }
    for (const auto& [word, number] : option.words)
    {
        what += ", " + word;
    }
    if (!option.nothing.empty())
    {
        what += " or " + option.nothing;
    }
    return what;
}

std::string nearestAllowed(const Option& option, const OptionValue& value)
{
    const auto* text = std::get_if<std::string>(&value);
    const std::string nearest = text ? nearestName(*text, option.choices) : "";
    return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

std::string refusalText(const Option& option, std::string_view name, std::string_view text)
{
    return fmt::format("{} is '{}', but it must be {}{}", name, text, describeAllowed(option),
                       nearestAllowed(option, std::string(text)));
}

bool setOption(const Option& option, Scene& scene, OptionValue value)
{
    value = converted(option, std::move(value));
    return allowed(option, value) && option.set(scene, value);
}

std::optional<OptionValue> readOptionText(const Option& option, std::string_view text)
{
    const OptionValue word = converted(option, std::string(text));
    if (!std::holds_alternative<std::string>(word))
    {
        return word;
    }
    const auto wrap = [](const auto& value) -> std::optional<OptionValue>
    { return value ? std::optional<OptionValue>(*value) : std::nullopt; };
    switch (option.type)
    {
    case OptionType::boolean:
        if (text == "true" || text == "false")
        {
            return text == "true";
        }
        return std::nullopt;
    case OptionType::integer:
        return wrap(readNumber<std::int64_t>(text));
    case OptionType::number:
        return wrap(readNumber<double>(text));
    case OptionType::vector:
        return wrap(readVector(text));
    case OptionType::radii:
        if (const auto number = readNumber<double>(text))
        {
            return *number;
        }
        break;
    case OptionType::text:
        break;
    }
    return word;
}

std::string optionText(const Option& option, const OptionValue& value)
{
    if (std::holds_alternative<std::monostate>(value))
    {
        return option.nothing;
    }
    if (const auto* yes = std::get_if<bool>(&value))
    {
        return *yes ? "true" : "false";
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value))
    {
        return fmt::format("{}", *whole);
    }
    if (const auto* number = std::get_if<double>(&value))
    {
        return fmt::format("{}", *number);
    }
    if (const auto* vector = std::get_if<Eigen::Vector3d>(&value))
    {
        return fmt::format("{},{},{}", vector->x(), vector->y(), vector->z());
    }
    return std::get<std::string>(value);
}

} // namespace frostfill

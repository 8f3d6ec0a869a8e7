// SPDX-License-Identifier: MIT
#include "app/scene_options.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace frostfill
{
namespace
{

/// What stands behind the flag in the help.
std::string placeholder(const Option& option)
{
    std::string what;
    switch (option.type)
    {
    case OptionType::boolean:
        return "";
    case OptionType::integer:
        what = "N";
        break;
    case OptionType::number:
        what = "X";
        break;
    case OptionType::vector:
        what = "X,Y,Z";
        break;
    case OptionType::radii:
        what = "X|X..Y|FILE";
        break;
    case OptionType::text:
        what = option.texts().empty() ? option.placeholder
                                      : fmt::format("{}", fmt::join(option.texts(), "|"));
        break;
    }
    for (const auto& [word, number] : option.words)
    {
        what += "|" + word;
    }
    return option.nothing.empty() ? what : what + "|" + option.nothing;
}

std::string presetName(Preset preset)
{
    Scene scene;
    scene.preset = preset;
    const Option& option = *findOption("preset");
    return optionText(option, option.get(scene));
}

std::string helpWithDefault(const Option& option)
{
    // The count and the groups depend on the object; the help shows those of the torus.
    const Scene standard = presetScene(Preset::fast, "torus");
    return fmt::format("{}{} ({})", option.help,
                       option.preset ? fmt::format("; preset {}", presetName(*option.preset)) : "",
                       optionText(option, option.get(standard)));
}

void addOption(CLI::App& command, const Option& option, GivenOptions& given,
               const std::string& help)
{
    const auto keep = [&given, key = option.key](const std::string& text) { given[key] = text; };
    CLI::Option* added = nullptr;
    if (option.type == OptionType::boolean)
    {
        added = command.add_flag_function(
            fmt::format("{},!--no-{}", option.flag, option.flag.substr(2)),
            [keep](std::int64_t times) { keep(times > 0 ? "true" : "false"); }, help);
    }
    else
    {
        added = command.add_option_function<std::string>(option.flag, keep, help)
                    ->type_name(placeholder(option));
    }
    added->group(option.group);
}

void addOption(CLI::App& command, const Option& option, GivenOptions& given)
{
    addOption(command, option, given, helpWithDefault(option));
}

} // namespace

void addSceneOptions(CLI::App& command, GivenOptions& given)
{
    for (const Option& option : sceneOptions())
    {
        if (!option.flag.empty())
        {
            addOption(command, option, given);
        }
    }
}

void addPictureOptions(CLI::App& command, GivenOptions& given)
{
    constexpr std::array<std::string_view, 3> kGroups = {"Frames", "Picture", "Camera"};
    constexpr std::array<std::string_view, 3> kOfTheRun = {"frames.slow_motion", "frames.duration",
                                                           "frames.keep_run"};
    const auto isIn = [](const auto& names, const std::string& name)
    { return std::find(names.begin(), names.end(), name) != names.end(); };
    for (const Option& option : sceneOptions())
    {
        if (!option.flag.empty() && isIn(kGroups, option.group) && !isIn(kOfTheRun, option.key))
        {
            addOption(command, option, given, option.help); // otherwise it is as in the run
        }
    }
}

void addLoadOptions(CLI::App& command, GivenOptions& given)
{
    for (const char* key : {"object.lid", "object.wrap", "object.unite"})
    {
        addOption(command, *findOption(key), given);
    }
}

void addUpOption(CLI::App& command, GivenOptions& given)
{
    addOption(command, *findOption("object.up"), given);
}

void addCheckOptions(CLI::App& command, GivenOptions& given)
{
    addUpOption(command, given);
    addLoadOptions(command, given);
}

std::vector<std::string> withImpliedValues(int count, const char* const* arguments)
{
    std::vector<std::string> result;
    for (int i = 1; i < count; ++i)
    {
        result.emplace_back(arguments[i]);
        for (const Option& option : sceneOptions())
        {
            // What cannot be a value is the next argument: `--wrap part.stl`.
            if (!option.implied.empty() && option.flag == result.back() &&
                (i + 1 == count || !readOptionText(option, arguments[i + 1]) ||
                 std::string_view(arguments[i + 1]).starts_with("--")))
            {
                result.back() += "=" + option.implied;
                break;
            }
        }
    }
    return result;
}

void applyGivenOptions(const GivenOptions& given, Scene& scene)
{
    // In the table's order, not the command line's: a style comes before the colours that differ.
    for (const Option& option : sceneOptions())
    {
        const auto found = given.find(option.key);
        if (found == given.end())
        {
            continue;
        }
        const std::string& text = found->second;
        const auto value = readOptionText(option, text);
        if (!value || !setOption(option, scene, *value))
        {
            throw Error(ErrorCode::usage,
                        fmt::format("{} is '{}', but it must be {}{}", option.flag, text,
                                    describeAllowed(option), nearestAllowed(option, text)));
        }
    }
}

std::string ignoredOptionsText(const GivenOptions& given, Preset preset)
{
    std::vector<std::string> ignored;
    for (const Option& option : sceneOptions())
    {
        if (option.preset && option.preset != preset && given.contains(option.key))
        {
            ignored.push_back(option.flag);
        }
    }
    if (ignored.empty())
    {
        return "";
    }
    const Preset other = preset == Preset::fast ? Preset::paper : Preset::fast;
    return fmt::format("the preset {} does not use {}; the preset {} does", presetName(preset),
                       fmt::join(ignored, ", "), presetName(other));
}

} // namespace frostfill

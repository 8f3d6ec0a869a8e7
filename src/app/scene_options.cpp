// SPDX-License-Identifier: MIT
#include "app/scene_options.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

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
        what = option.choices.empty() ? option.placeholder
                                      : fmt::format("{}", fmt::join(option.choices, "|"));
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
    const Option& option = optionOf("preset");
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
    const auto keep = [&given, &option](const std::string& text) { given[&option] = text; };
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
    if (!option.complement.empty())
    {
        command
            .add_option_function<double>(
                option.complement, [keep](double one) { keep(fmt::format("{:.12g}", 1 - one)); },
                fmt::format("1 minus {}", option.flag))
            ->type_name("X")
            ->group(option.group)
            ->excludes(added);
    }
}

void addOptions(CLI::App& command, GivenOptions& given, OptionUse use)
{
    for (const Option* option : optionsFor(use))
    {
        if (!option->flag.empty())
        {
            // What is not given for the pictures of a run that is over is as in the run.
            addOption(command, *option, given,
                      use == OptionUse::pictures ? option->help : helpWithDefault(*option));
        }
    }
}

} // namespace

void addSceneOptions(CLI::App& command, GivenOptions& given)
{
    addOptions(command, given, OptionUse::filling);
}

void addPictureOptions(CLI::App& command, GivenOptions& given)
{
    addOptions(command, given, OptionUse::pictures);
}

void addLoadOptions(CLI::App& command, GivenOptions& given)
{
    addOptions(command, given, OptionUse::loading);
}

void addUpOption(CLI::App& command, GivenOptions& given)
{
    const Option& up = optionOf("object.up");
    addOption(command, up, given, helpWithDefault(up));
}

void addCheckOptions(CLI::App& command, GivenOptions& given)
{
    addOptions(command, given, OptionUse::judging);
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
    for (const auto& [option, text] : given)
    {
        const auto value = readOptionText(*option, text);
        if (!value || !setOption(*option, scene, *value))
        {
            const std::string name =
                option->complement.empty()
                    ? option->flag
                    : fmt::format("{} (1 minus {})", option->flag, option->complement);
            throw Error(ErrorCode::usage, refusalText(*option, name, text));
        }
    }
}

std::string ignoredOptionsText(const GivenOptions& given, Preset preset)
{
    std::vector<std::string> ignored;
    for (const Option* option : ignoredOptions(given, preset))
    {
        ignored.push_back(option->flag);
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

// SPDX-License-Identifier: MIT
#include "app/scene_options.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

namespace frostfill
{
namespace
{

/// The help shows so many words in place of a name at most.
constexpr std::size_t kMaxWords = 6;

/// Returns the options of a command. Only --set changes runs that a file describes.
std::vector<const Option*> optionsOf(std::string_view command)
{
    if (command == "import")
    {
        return {&optionOf("object.up")};
    }
    const bool hasPacking = command == "check" || command == "analyse";
    std::vector<const Option*> options = optionsFor(command == "render" ? OptionUse::pictures
                                                    : command == "mesh" ? OptionUse::loading
                                                    : hasPacking        ? OptionUse::judging
                                                                        : OptionUse::filling);
    if (command == "analyse")
    {
        std::erase_if(options, [](const Option* each) { return each->key.starts_with("judge."); });
    }
    return options;
}

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
               : option.choices.size() > kMaxWords
                   ? "NAME"
                   : fmt::format("{}", fmt::join(option.choices, "|"));
        break;
    }
    for (const auto& [word, number] : option.words)
    {
        what += "|" + word;
    }
    return option.nothing.empty() || !option.choices.empty() || option.type == OptionType::text
               ? what
               : what + "|" + option.nothing;
}

std::string presetName(Preset preset)
{
    Scene scene;
    scene.preset = preset;
    const Option& option = optionOf("preset");
    return optionText(option, option.get(scene));
}

/// The count and the groups depend on the object; the help shows those of the torus.
std::string defaultText(const Option& option)
{
    static const Scene kStandard = presetScene(Preset::fast, "torus");
    return optionText(option, option.get(kStandard));
}

/// Throws Error usage where the option has a value already.
void keep(GivenOptions& given, const Option& option, const std::string& name,
          const std::string& text)
{
    if (const auto [at, isNew] = given.try_emplace(&option, GivenOption{name, text}); !isNew)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("{} is given twice, as {} and as {}: give it once", option.key,
                                at->second.name, name));
    }
}

void addFlag(CLI::App& command, const Option& option, GivenOptions& given)
{
    const auto take = [&given, &option](const std::string& text)
    { keep(given, option, option.flag, text); };
    // Settings of pictures that `render` is not given are those of the run: no default is shown.
    const std::string help = command.get_name() == "render"
                                 ? option.help
                                 : fmt::format("{} ({})", option.help, defaultText(option));
    CLI::Option* added = nullptr;
    if (option.type == OptionType::boolean)
    {
        added = command.add_flag_function(
            fmt::format("{},!--no-{}", option.flag, option.flag.substr(2)),
            [take](std::int64_t times) { take(times > 0 ? "true" : "false"); }, help);
    }
    else
    {
        added = command.add_option_function<std::string>(option.flag, take, help)
                    ->type_name(placeholder(option));
    }
    added->group(option.group);
}

/// Takes "spheres.count=300".
void takeSetting(const std::string& setting, std::string_view command, GivenOptions& given)
{
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals + 1 == setting.size())
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--set {} has no value: give --set KEY=VALUE", setting));
    }
    const std::string key = setting.substr(0, equals);
    const Option* option = findOption(key);
    if (option == nullptr)
    {
        throw Error(ErrorCode::usage,
                    fmt::format("--set: unknown key '{}'{}", key, didYouMeanKey(key)));
    }
    const std::vector<const Option*> taken = optionsOf(command);
    if (std::find(taken.begin(), taken.end(), option) == taken.end())
    {
        throw Error(ErrorCode::usage, fmt::format("{0} does not use the key {1}; see frostfill {0} "
                                                  "--help-all",
                                                  command, key));
    }
    keep(given, *option, key, setting.substr(equals + 1));
}

} // namespace

CLI::Option* addMeshArgument(CLI::App& command, const char* name, std::string& mesh,
                             const std::string& help)
{
    const auto take = [&mesh](const std::vector<std::string>& names)
    { mesh = fmt::format("{}", fmt::join(names, "+")); };
    return command.add_option_function<std::vector<std::string>>(name, take, help);
}

void addSceneOptions(CLI::App& command, GivenOptions& given)
{
    const std::string name = command.get_name();
    if (name != "sweep" && name != "fps")
    {
        for (const Option* option : optionsOf(name))
        {
            if (!option->flag.empty())
            {
                addFlag(command, *option, given);
            }
        }
    }
    if (name == "fill")
    {
        const auto take = [&given](double porosity)
        {
            keep(given, optionOf("rest.fraction"), "--fraction (1 minus --porosity)",
                 fmt::format("{:.15g}", 1 - porosity));
        };
        command.add_option_function<double>("--porosity", take, "1 minus --fraction")
            ->type_name("X")
            ->group("Rest");
    }
    command
        .add_option_function<std::vector<std::string>>(
            "--set",
            [&given, name](const std::vector<std::string>& settings)
            {
                for (const std::string& setting : settings)
                {
                    takeSetting(setting, name, given);
                }
            },
            "Any key of the scene, several times; --help-all lists the keys")
        ->allow_extra_args(false)
        ->type_name("KEY=VALUE")
        ->group(name == "fill" || name == "render" ? "Output" : "Options");
}

std::string sceneKeysText(const CLI::App& command)
{
    if (command.get_option_no_throw("--set") == nullptr)
    {
        return "";
    }
    std::string text = "\nKeys of the scene, for --set KEY=VALUE and scene files:\n";
    std::string group;
    for (const Option* option : optionsOf(command.get_name()))
    {
        text += option->group == group ? "" : fmt::format(" {}\n", option->group);
        group = option->group;
        text += fmt::format("  {:<26} {}{}: {} ({})\n", option->key, option->help,
                            option->preset ? fmt::format("; preset {}", presetName(*option->preset))
                                           : "",
                            describeAllowed(*option), defaultText(*option));
    }
    return text;
}

void applyGivenOptions(const GivenOptions& given, Scene& scene)
{
    // In the table's order, not the command line's: a style comes before the colours that differ.
    for (const auto& [option, value] : given)
    {
        const auto read = readOptionText(*option, value.text);
        if (!read || !setOption(*option, scene, *read))
        {
            throw Error(ErrorCode::usage, refusalText(*option, value.name, value.text));
        }
    }
}

std::string ignoredOptionsText(const GivenOptions& given, Preset preset)
{
    std::vector<std::string> ignored;
    for (const Option* option : ignoredOptions(given, preset))
    {
        ignored.push_back(given.at(option).name);
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

// SPDX-License-Identifier: MIT
#include "run/options_page.hpp"

#include <frostfill/options.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

std::string flagText(const Option& option)
{
    if (option.flag.empty())
    {
        return "–";
    }
    return option.type == OptionType::boolean
               ? fmt::format("`{}`, `--no-{}`", option.flag, option.flag.substr(2))
           : option.complement.empty() ? fmt::format("`{}`", option.flag)
                                       : fmt::format("`{}`, `{}`", option.flag, option.complement);
}

std::string presetText(const Option& option)
{
    if (!option.preset)
    {
        return "";
    }
    return *option.preset == Preset::fast ? " (preset fast)" : " (preset paper)";
}

} // namespace

std::string sceneOptionsMarkdown()
{
    // The count and the groups depend on the object; the page shows those of the torus.
    const Scene standard = presetScene(Preset::fast, "torus");
    std::string text;
    std::string group;
    for (const Option& option : sceneOptions())
    {
        if (option.group != group)
        {
            group = option.group;
            text += fmt::format("\n### {}\n\n| option | key | values | default | meaning |\n"
                                "|---|---|---|---|---|\n",
                                group);
        }
        const std::string value = optionText(option, option.get(standard));
        text += fmt::format("| {} | `{}` | {} | {} | {}{} |\n", flagText(option), option.key,
                            describeAllowed(option), value, option.help, presetText(option));
    }
    return text;
}

bool isSceneOption(std::string_view flag)
{
    const auto options = sceneOptions();
    return std::any_of(options.begin(), options.end(),
                       [&](const Option& option)
                       { return option.flag == flag || option.complement == flag; });
}

} // namespace frostfill

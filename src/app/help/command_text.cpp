// SPDX-License-Identifier: MIT
#include "app/help/command_text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <regex>

namespace frostfill
{
namespace
{

/// "fast" is a word to type; "FILE", "X..Y" and "plane:X,Y,Z" stand for something.
bool isWord(const std::string& part)
{
    return !part.empty() && std::all_of(part.begin(), part.end(),
                                        [](unsigned char letter) {
                                            return std::islower(letter) != 0 ||
                                                   std::isdigit(letter) != 0 || letter == '-';
                                        });
}

OptionText textOf(const CLI::Option& option)
{
    OptionText text;
    text.positional = option.get_positional();
    // "{false}" stands behind the negative form of a flag.
    for (const std::string& name : CLI::detail::split(option.get_name(text.positional, true), ','))
    {
        text.names.push_back(name.substr(0, name.find('{')));
    }
    text.help = option.get_description();
    if (text.positional || option.get_type_size() == 0)
    {
        return text;
    }
    // CLI11 appends what it checks: ":INT in [1 - 5]" or ":{list,tree}".
    static const std::regex kChecks(R"(:(\{.*\}|NONNEGATIVE|[A-Z]+ in \[.*\])$)");
    text.value = std::regex_replace(option.get_type_name(), kChecks, "");
    for (const std::string& part : CLI::detail::split(text.value, '|'))
    {
        if (isWord(part))
        {
            text.choices.push_back(part);
        }
    }
    return text;
}

void add(const CLI::App& command, const std::string& name, std::vector<CommandText>& texts)
{
    CommandText text{name, {}};
    for (const CLI::Option* option : command.get_options())
    {
        text.options.push_back(textOf(*option));
    }
    texts.push_back(std::move(text));
    for (const CLI::App* inner : command.get_subcommands(nullptr))
    {
        add(*inner, name + " " + inner->get_name(), texts);
    }
}

} // namespace

std::vector<CommandText> commandTexts(const CLI::App& program)
{
    std::vector<CommandText> texts;
    for (const CLI::App* command : program.get_subcommands(nullptr))
    {
        add(*command, command->get_name(), texts);
    }
    return texts;
}

} // namespace frostfill

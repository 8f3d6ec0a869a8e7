// SPDX-License-Identifier: MIT
#include "app/help/command_text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>

namespace frostfill
{
namespace
{

/// "fast" is a word to type; "FILE" and "X..Y" stand for something.
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
    // Behind a colon CLI11 describes what it checks.
    const std::string type = option.get_type_size() == 0 ? "" : option.get_type_name();
    text.value = text.positional ? "" : type.substr(0, type.find(':'));
    text.help = option.get_description();
    text.group = option.get_group();
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
    CommandText text{name, command.get_description(), {}, command.get_footer()};
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

// SPDX-License-Identifier: MIT
#include "app/help/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace frostfill
{
namespace
{

/// The words after the command itself: the commands inside it, and its options.
std::string wordsAfter(const CommandText& command, const std::vector<CommandText>& commands)
{
    std::vector<std::string> words;
    const std::string inner = command.name + " ";
    for (const CommandText& other : commands)
    {
        if (other.name.starts_with(inner))
        {
            words.push_back(other.name.substr(inner.size()));
        }
    }
    for (const OptionText& option : command.options)
    {
        if (!option.positional)
        {
            words.insert(words.end(), option.names.begin(), option.names.end());
        }
    }
    return fmt::format("{}", fmt::join(words, " "));
}

std::vector<std::string> commandNames(const std::vector<CommandText>& commands)
{
    std::vector<std::string> names;
    for (const CommandText& command : commands)
    {
        if (command.name.find(' ') == std::string::npos)
        {
            names.push_back(command.name);
        }
    }
    return names;
}

} // namespace

std::string bashCompletion(const std::vector<CommandText>& commands)
{
    std::string text =
        "# Completion of frostfill for bash, written by frostfill completion bash\n"
        "_frostfill()\n{\n"
        "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
        "    local command= words= word\n"
        "    for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
        "        case $command,$word in\n";
    for (const CommandText& command : commands)
    {
        const std::size_t space = command.name.find(' ');
        const std::string outer = space == std::string::npos ? "" : command.name.substr(0, space);
        const std::string inner = command.name.substr(space == std::string::npos ? 0 : space + 1);
        text += fmt::format("            '{},{}') command='{}' ;;\n", outer, inner, command.name);
    }
    text += "        esac\n    done\n    case $command,$before in\n";
    for (const CommandText& command : commands)
    {
        for (const OptionText& option : command.options)
        {
            if (!option.choices.empty())
            {
                text += fmt::format("        '{},{}') words='{}' ;;\n", command.name,
                                    option.names.front(), fmt::join(option.choices, " "));
            }
        }
    }
    text += "        *) case $command in\n";
    text += fmt::format("            '') words='{} --help --version' ;;\n",
                        fmt::join(commandNames(commands), " "));
    for (const CommandText& command : commands)
    {
        text += fmt::format("            '{}') words='{}' ;;\n", command.name,
                            wordsAfter(command, commands));
    }
    text += "        esac ;;\n    esac\n"
            "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
            "}\ncomplete -o bashdefault -o default -F _frostfill frostfill\n";
    return text;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "app/help/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

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

/// A function of bash that sets `words` for the command line so far. zsh runs it as well.
std::string bashScript(const std::vector<CommandText>& commands)
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

/// Quoted for zsh and fish.
std::string inQuotes(const std::string& text)
{
    std::string escaped = "'";
    for (const char letter : text)
    {
        escaped += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    }
    return escaped + "'";
}

/// In a specification of _arguments, brackets and colons have a meaning.
std::string zshHelp(const std::string& help)
{
    std::string escaped;
    for (const char letter : help)
    {
        if (letter == '[' || letter == ']' || letter == ':')
        {
            escaped += '\\';
        }
        escaped += letter;
    }
    return escaped;
}

std::string zshScript(const std::vector<CommandText>& commands)
{
    std::string text = "#compdef frostfill\n"
                       "# Completion of frostfill for zsh, written by frostfill completion zsh\n"
                       "local command=$words[2] inner=$words[3]\n"
                       "if (( CURRENT == 2 )); then\n    local -a commands=(\n";
    for (const CommandText& command : commands)
    {
        if (command.name.find(' ') == std::string::npos)
        {
            text +=
                fmt::format("        {}\n", inQuotes(command.name + ":" + zshHelp(command.help)));
        }
    }
    text += "    )\n    _describe command commands\n    return\nfi\ncase \"$command $inner\" in\n";
    // Commands within others come first, because the pattern of the outer one fits them too.
    std::vector<CommandText> byDepth = commands;
    std::stable_sort(byDepth.begin(), byDepth.end(),
                     [](const CommandText& a, const CommandText& b)
                     {
                         const auto depth = [](const CommandText& command)
                         { return std::count(command.name.begin(), command.name.end(), ' '); };
                         return depth(a) > depth(b);
                     });
    for (const CommandText& command : byDepth)
    {
        text += fmt::format("    {}*) _arguments", inQuotes(command.name + " "));
        for (const OptionText& option : command.options)
        {
            for (const std::string& name : option.names)
            {
                const std::string value =
                    option.value.empty() || option.positional ? ""
                    : option.choices.empty()
                        ? ":value:_files"
                        : fmt::format(":value:({})", fmt::join(option.choices, " "));
                text += ' ';
                text += option.positional
                            ? "'*:file:_files'"
                            : inQuotes(fmt::format("{}[{}]{}", name, zshHelp(option.help), value));
            }
        }
        text += " ;;\n";
    }
    return text + "esac\n";
}

std::string fishScript(const std::vector<CommandText>& commands)
{
    std::string text = "# Completion of frostfill for fish, written by frostfill completion fish\n";
    const std::string names = fmt::format("{}", fmt::join(commandNames(commands), " "));
    for (const CommandText& command : commands)
    {
        const std::size_t space = command.name.find(' ');
        const std::string outer = command.name.substr(0, space);
        std::string where = fmt::format("__fish_seen_subcommand_from {}", outer);
        if (space == std::string::npos)
        {
            text += fmt::format("complete -c frostfill -n {} -a {} -d {}\n",
                                inQuotes("not __fish_seen_subcommand_from " + names),
                                inQuotes(command.name), inQuotes(command.help));
        }
        else
        {
            const std::string inner = command.name.substr(space + 1);
            text += fmt::format("complete -c frostfill -n {} -a {} -d {}\n", inQuotes(where),
                                inQuotes(inner), inQuotes(command.help));
            where += "; and __fish_seen_subcommand_from " + inner;
        }
        for (const OptionText& option : command.options)
        {
            for (const std::string& name : option.names)
            {
                if (option.positional || !name.starts_with("--"))
                {
                    continue;
                }
                const std::string value =
                    option.value.empty() ? ""
                    : option.choices.empty()
                        ? " -r"
                        : " -x -a " + inQuotes(fmt::format("{}", fmt::join(option.choices, " ")));
                text += fmt::format("complete -c frostfill -n {} -l {}{} -d {}\n", inQuotes(where),
                                    name.substr(2), value, inQuotes(option.help));
            }
        }
    }
    return text;
}

} // namespace

std::vector<std::string> shells()
{
    return {"bash", "zsh", "fish"};
}

std::string completionScript(std::string_view shell, const std::vector<CommandText>& commands)
{
    return shell == "bash"  ? bashScript(commands)
           : shell == "zsh" ? zshScript(commands)
                            : fishScript(commands);
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace frostfill::test
{

/// Commands in code blocks, which are indented, and between backticks.
inline std::vector<std::string> commandsOf(const std::string& text)
{
    static const std::regex kCommand(
        "(?:^|\\n)    ((?:build/release/)?frostfill [^\\n]*)|`((?:build/release/)?frostfill "
        "[^`\\n]*)`|(?:^|\\n)    (gnuplot [^\\n]*)");
    std::vector<std::string> commands;
    for (std::sregex_iterator it(text.begin(), text.end(), kCommand), end; it != end; ++it)
    {
        for (std::size_t group = 1; group <= 3; ++group)
        {
            if ((*it)[group].matched)
            {
                commands.push_back((*it)[group].str());
            }
        }
    }
    return commands;
}

/// The names in what `frostfill --help` prints: after "Subcommands:" a command a line, and what
/// goes on from it is indented further.
inline std::vector<std::string> commandsOfHelp(const std::string& help)
{
    std::istringstream lines(help.substr(help.find("Subcommands:")));
    std::string line;
    std::getline(lines, line);
    std::vector<std::string> commands;
    while (std::getline(lines, line) && line.starts_with("  "))
    {
        if (line[2] != ' ')
        {
            commands.push_back(line.substr(2, line.find(' ', 2) - 2));
        }
    }
    return commands;
}

/// The program's arguments, without what explains them, with real names for placeholders.
inline std::string argumentsOf(std::string command)
{
    command = command.substr(command.find("frostfill ") + std::string("frostfill ").size());
    command = command.substr(0, command.find("  "));
    for (const auto& [from, to] :
         std::vector<std::pair<std::string, std::string>>{{"\\bFILE\\.toml\\b", "scene.toml"},
                                                          {"\\b(FILE|MESH)\\b", "part.stl"},
                                                          {"\\bDIR\\b", "somewhere"},
                                                          {"\\bOPTIONS\\.\\.\\.", ""}})
    {
        command = std::regex_replace(command, std::regex(from), to);
    }
    return command;
}

/// The same command with little to do.
inline std::string madeSmall(std::string arguments)
{
    if (arguments.find("--help") != std::string::npos)
    {
        return arguments;
    }
    const std::string name = arguments.substr(0, arguments.find(' '));
    const auto without = [&](const std::string& option)
    { arguments = std::regex_replace(arguments, std::regex(" --" + option + "[ =][^ ]+"), ""); };
    std::string small;
    if (arguments.rfind("fill --resume", 0) == 0)
    {
        return arguments;
    }
    if (name == "render")
    {
        without("size");
        without("supersample");
        const bool drawsAll = arguments.find("--shard") == std::string::npos &&
                              arguments.find("--gather") == std::string::npos;
        return arguments + " --size 64x48" + (drawsAll ? " --overwrite" : "");
    }
    if (name == "fill")
    {
        for (const char* option : {"count", "size", "max-frames"})
        {
            without(option);
        }
        if (arguments.find("--inlet") == std::string::npos) // too narrow for larger spheres
        {
            without("radius");
        }
        const bool draws = arguments.find("--frames none") == std::string::npos;
        small = draws ? " --count 6 --size 64x48 --max-frames 2" : " --count 6";
        if (arguments.find("--overwrite") == std::string::npos &&
            arguments.find("--resume") == std::string::npos)
        {
            small += " --overwrite";
        }
    }
    else if (name == "fps")
    {
        without("count");
        without("repeats");
        small = " --count 12 --repeats 1";
        // The times of so few frames differ by anything.
        if (arguments.find("--compare") != std::string::npos)
        {
            small += " --threshold 1000000";
        }
        without("threshold");
    }
    else if ((name == "bench" || name == "figures") &&
             arguments.find("--quick") == std::string::npos &&
             arguments.find("--list") == std::string::npos)
    {
        return arguments + " --quick";
    }
    return name + small + arguments.substr(name.size());
}

} // namespace frostfill::test

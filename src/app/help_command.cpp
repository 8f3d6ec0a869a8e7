// SPDX-License-Identifier: MIT
// Commands that say how to use the others: help, version, completion.
#include "app/commands.hpp"
#include "app/help/completion.hpp"

#include <frostfill/error.hpp>
#include <frostfill/options.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace frostfill
{
namespace
{

/// The help of the command of this name.
std::string helpOf(const CLI::App& program, const std::vector<std::string>& names)
{
    const CLI::App* found = &program;
    std::string whole = program.get_name();
    for (const std::string& name : names)
    {
        const CLI::App* next = nullptr;
        std::vector<std::string> known;
        for (const CLI::App* command : found->get_subcommands(nullptr))
        {
            known.push_back(command->get_name());
            next = command->get_name() == name ? command : next;
        }
        if (next == nullptr)
        {
            const std::string nearest = nearestName(name, known);
            throw Error(ErrorCode::usage,
                        fmt::format("no command '{}'; {}", name,
                                    nearest.empty() ? "see frostfill --help"
                                                    : fmt::format("did you mean {}?", nearest)));
        }
        found = next;
        whole += " " + name;
    }
    // App::help would give that of the command which was given, which is this one.
    return found->get_formatter()->make_help(found, whole, CLI::AppFormatMode::Normal);
}

} // namespace

Command addHelpCommand(CLI::App& program)
{
    const auto names = std::make_shared<std::vector<std::string>>();
    CLI::App* command = program.add_subcommand("help", "Print the help of a command");
    command->add_option("COMMAND", *names, "Such as fill");
    command->footer("Examples:\n  frostfill help fill\n");
    return [names, &program]
    {
        fmt::print("{}", helpOf(program, *names));
        return 0;
    };
}

Command addVersionCommand(CLI::App& program)
{
    program.add_subcommand("version", "Print the version")
        ->footer("Examples:\n  frostfill version\n");
    return []
    {
        fmt::print("frostfill {}\n", FROSTFILL_VERSION);
        return 0;
    };
}

Command addCompletionCommand(CLI::App& program)
{
    const auto shell = std::make_shared<std::string>();
    CLI::App* command =
        program.add_subcommand("completion", "Print a script that completes commands in a shell");
    command->add_option("SHELL", *shell, "bash")->required()->check(CLI::IsMember({"bash"}));
    command->footer("Examples:\n  frostfill completion bash > "
                    "~/.local/share/bash-completion/completions/frostfill\n"
                    "  source <(frostfill completion bash)      in this shell\n");
    return [shell, &program]
    {
        fmt::print("{}", bashCompletion(commandTexts(program)));
        return 0;
    };
}

} // namespace frostfill

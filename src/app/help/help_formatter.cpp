// SPDX-License-Identifier: MIT
#include "app/help/help_formatter.hpp"

#include <fmt/format.h>

#include <regex>
#include <utility>

namespace frostfill
{

HelpFormatter::HelpFormatter(std::function<std::string(const CLI::App&)> keysOf)
    : keysOf_(std::move(keysOf))
{
    column_width(12);
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool positional) const
{
    // "{false}" stands behind the negative form of a flag.
    std::string name = option->get_name(positional, !positional);
    name = name.substr(0, name.find('{'));
    if (!positional && option->get_type_size() != 0)
    {
        // CLI11 appends what it checks: ":INT in [1 - 5]" or ":{list,tree}".
        static const std::regex kChecks(R"(:(\{.*\}|NONNEGATIVE|[A-Z]+ in \[.*\])$)");
        name += " " + std::regex_replace(option->get_type_name(), kChecks, "");
    }
    return fmt::format("  {:<38} {}\n", name, option->get_description());
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const
{
    std::string text = make_description(app) + make_usage(app, name) + make_positionals(app);
    for (const std::string& group : app->get_groups())
    {
        const auto options =
            app->get_options([&](const CLI::Option* option)
                             { return option->nonpositional() && option->get_group() == group; });
        text += group.empty() || options.empty() ? "" : make_group(group, false, options);
    }
    text += make_subcommands(app, CLI::AppFormatMode::Normal);
    if (mode == CLI::AppFormatMode::All)
    {
        text += keysOf_(*app);
    }
    const auto isShown = [](const CLI::App* command) { return !command->get_group().empty(); };
    for (const CLI::App* command : app->get_subcommands(isShown))
    {
        text += mode == CLI::AppFormatMode::All
                    ? "\n" + make_help(command, name + " " + command->get_name(), mode)
                    : "";
    }
    return text + "\n" + make_footer(app);
}

} // namespace frostfill

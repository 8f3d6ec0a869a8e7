// SPDX-License-Identifier: MIT
#include "app/help/man_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// Text in which nothing is a request or an escape of roff.
std::string plain(const std::string& text)
{
    std::string escaped;
    bool lineBegins = true;
    for (const char letter : text)
    {
        if (lineBegins && (letter == '.' || letter == '\''))
        {
            escaped += "\\&";
        }
        lineBegins = letter == '\n';
        if (letter == '\\')
        {
            escaped += "\\e";
        }
        else if (letter == '-')
        {
            escaped += "\\-"; // a sign to copy, and no hyphen
        }
        else
        {
            escaped += letter;
        }
    }
    return escaped;
}

std::string head(const std::string& page, const std::string& purpose)
{
    std::string upper = page;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char letter) { return std::toupper(letter); });
    return fmt::format(
        ".TH \"{}\" 1 \"\" \"Frostfill {}\" \"Frostfill\"\n.nh\n.SH NAME\n{} \\- {}\n",
        plain(upper), FROSTFILL_VERSION, plain(page), plain(purpose));
}

std::string verbatim(const std::string& text)
{
    return ".nf\n" + plain(text) + (text.ends_with('\n') ? "" : "\n") + ".fi\n";
}

std::string synopsis(const CommandText& command)
{
    std::string line = fmt::format(".B frostfill {}\n[\\fIoptions\\fR]", plain(command.name));
    for (const OptionText& option : command.options)
    {
        if (option.positional)
        {
            line += fmt::format(" [\\fI{}\\fR]", plain(option.names.front()));
        }
    }
    return ".SH SYNOPSIS\n" + line + "\n";
}

/// A list of words may be broken between them.
std::string breakable(const std::string& words)
{
    std::string text;
    for (const char letter : plain(words))
    {
        text += letter;
        text += letter == '|' ? "\\:" : "";
    }
    return text;
}

std::string optionEntry(const OptionText& option)
{
    std::vector<std::string> names;
    for (const std::string& name : option.names)
    {
        names.push_back((option.positional ? "\\fI" : "\\fB") + plain(name) + "\\fR");
    }
    const std::string value =
        option.value.empty() ? "" : " \\fI" + breakable(option.value) + "\\fR";
    return fmt::format(".TP\n{}{}\n{}\n", fmt::join(names, ", "), value, plain(option.help));
}

std::string options(const CommandText& command)
{
    std::string text = ".SH OPTIONS\n";
    std::string group = "Options";
    for (const OptionText& option : command.options)
    {
        if (option.group != group && !option.positional && !option.group.empty())
        {
            group = option.group;
            text += fmt::format(".SS {}\n", plain(group));
        }
        text += optionEntry(option);
    }
    return text;
}

std::string pageName(const std::string& command)
{
    std::string name = "frostfill-" + command;
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

} // namespace

std::vector<std::pair<std::string, std::string>> manPages(const std::vector<CommandText>& commands,
                                                          const std::string& footer)
{
    std::vector<std::pair<std::string, std::string>> pages;
    std::string all =
        head("frostfill", "fill a mesh with falling spheres and draw it") +
        ".SH SYNOPSIS\n.B frostfill\n\\fIcommand\\fR [\\fIoptions\\fR]\n.SH COMMANDS\n";
    for (const CommandText& command : commands)
    {
        const std::string name = pageName(command.name);
        all += fmt::format(".TP\n.BR {} (1)\n{}\n", plain(name), plain(command.help));
        std::string page = head(name, command.help) + synopsis(command) + options(command);
        if (!command.footer.empty())
        {
            page += ".SH EXAMPLES\n" + verbatim(command.footer);
        }
        page += ".SH SEE ALSO\n.BR frostfill (1)\n";
        pages.emplace_back(name + ".1", page);
    }
    all += ".SH EXAMPLES\n" + verbatim(footer);
    pages.emplace(pages.begin(), "frostfill.1", all);
    return pages;
}

} // namespace frostfill

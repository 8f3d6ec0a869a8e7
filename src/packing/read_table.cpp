// SPDX-License-Identifier: MIT
#include "packing/timestep.hpp"

namespace frostfill
{
namespace
{

/// What separates the columns: a comma, a semicolon, or 0 for spaces and tabs.
char separatorOf(std::string_view heading)
{
    for (const char separator : {',', ';'})
    {
        if (heading.find(separator) != std::string_view::npos)
        {
            return separator;
        }
    }
    return 0;
}

bool isComment(std::string_view line)
{
    return line.find_first_not_of(" \t") == std::string_view::npos || line.front() == '#';
}

} // namespace

Timestep readTable(TextLines lines, double radius)
{
    std::string_view heading = lines.need("its heading");
    if (heading.starts_with("\xEF\xBB\xBF"))
    {
        heading.remove_prefix(3); // byte order mark of a spreadsheet
    }
    if (heading.starts_with('#'))
    {
        heading.remove_prefix(1);
    }
    const char separator = separatorOf(heading);
    SphereColumns columns;
    int index = 0;
    for (const std::string_view name : wordsOf(heading, separator))
    {
        columns.take(name, index++);
    }
    columns.keepPlacesOnly(); // the others may be words
    columns.requireAll(lines, radius);
    Timestep timestep;
    for (std::string_view line; lines.next(line);)
    {
        if (!isComment(line))
        {
            addSphere(wordsOf(line, separator), columns, radius, lines, timestep);
        }
    }
    return timestep;
}

} // namespace frostfill

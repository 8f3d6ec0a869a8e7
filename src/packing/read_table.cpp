// SPDX-License-Identifier: MIT
#include "base/read_number.hpp"
#include "packing/timestep.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

using TableWords = std::vector<std::string_view>;

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

bool areNumbers(const TableWords& words)
{
    return !words.empty() &&
           std::all_of(words.begin(), words.end(),
                       [](std::string_view word) { return readNumber<double>(word).has_value(); });
}

/// The index of a column that is given by its name, or by its number from 1.
int indexOfColumn(const std::string& column, const TableWords& heading, const TextLines& lines)
{
    const auto at = std::find(heading.begin(), heading.end(), column);
    if (at != heading.end() && !areNumbers(heading)) // which are the first sphere
    {
        return static_cast<int>(at - heading.begin());
    }
    const auto number = readNumber<std::size_t>(column);
    if (!number)
    {
        lines.refuse(
            areNumbers(heading)
                ? fmt::format("no heading that could have a column '{}'; give its number", column)
                : fmt::format("no column '{}' among {}", column, fmt::join(heading, ", ")));
    }
    if (*number == 0 || *number > heading.size())
    {
        lines.refuse(
            fmt::format("no column {}: there are {}, counted from 1", *number, heading.size()));
    }
    return static_cast<int>(*number) - 1;
}

/// Puts the columns that are given in the place of those that have the usual names.
void takeGiven(const PackingColumns& given, const TableWords& heading, const TextLines& lines,
               SphereColumns& columns)
{
    const auto take = [&](const std::string& name, int& column)
    {
        if (!name.empty())
        {
            column = indexOfColumn(name, heading, lines);
        }
    };
    take(given.x, columns.x);
    take(given.y, columns.y);
    take(given.z, columns.z);
    take(given.radius, columns.radius);
    take(given.diameter, columns.diameter);
    if (!given.diameter.empty())
    {
        columns.radius = -1;
    }
}

SphereColumns columnsOfTable(const TableWords& heading, const PackingFileOptions& options,
                             const TextLines& lines)
{
    SphereColumns columns;
    int index = 0;
    for (const std::string_view name : heading)
    {
        columns.take(name, index++);
    }
    columns.keepPlacesOnly(); // the others may be words
    takeGiven(options.columns, heading, lines, columns);
    if (areNumbers(heading) && !options.columns.any())
    {
        lines.refuse("no heading, but numbers: say which columns are which, as in --columns "
                     "x=1,y=2,z=3,radius=4");
    }
    columns.requireAll(lines, options.radius);
    return columns;
}

} // namespace

Timestep readTable(TextLines lines, const PackingFileOptions& options)
{
    std::string_view heading = lines.need("its heading");
    if (heading.starts_with("\xEF\xBB\xBF"))
    {
        heading.remove_prefix(3); // byte order mark of a spreadsheet
    }
    constexpr std::string_view kOfYade = "#format ";
    const bool isOfYade = heading.starts_with(kOfYade);
    heading.remove_prefix(isOfYade ? kOfYade.size() : heading.starts_with('#') ? 1 : 0);
    const char separator = separatorOf(heading);
    const TableWords names = wordsOf(heading, isOfYade ? '_' : separator);
    const SphereColumns columns = columnsOfTable(names, options, lines);
    Timestep timestep;
    const bool hasHeading = !areNumbers(names);
    if (!hasHeading)
    {
        addSphere(names, columns, options.radius, lines, timestep);
    }
    for (std::string_view line; lines.next(line);)
    {
        if (isComment(line))
        {
            continue;
        }
        const TableWords words = wordsOf(line, separator);
        if (!hasHeading && words.size() != names.size())
        {
            lines.refuse(fmt::format("{} values, where the first line has {}: leave out lines that "
                                     "are no spheres",
                                     words.size(), names.size()));
        }
        addSphere(words, columns, options.radius, lines, timestep);
    }
    return timestep;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "packing/text_lines.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

/// The columns that Properties=species:S:1:pos:R:3:radius:R:1 names; plain XYZ has a species and a
/// place.
SphereColumns columnsOf(std::string_view comment, const TextLines& lines)
{
    constexpr std::string_view kKey = "Properties=";
    std::string_view properties = "species:S:1:pos:R:3";
    if (const std::size_t at = comment.find(kKey); at != std::string_view::npos)
    {
        properties = comment.substr(at + kKey.size());
        if (properties.starts_with('"'))
        {
            properties.remove_prefix(1);
        }
        properties = properties.substr(0, properties.find_first_of(" \t\""));
    }
    const auto parts = wordsOf(properties, ':');
    SphereColumns columns;
    int column = 0;
    for (std::size_t i = 0; i + 2 < parts.size(); i += 3)
    {
        const auto count = static_cast<int>(countOf(parts[i + 2], lines));
        if (parts[i] == "pos" && count == 3)
        {
            columns.x = column;
            columns.y = column + 1;
            columns.z = column + 2;
        }
        else if (count == 1)
        {
            columns.take(parts[i], column);
        }
        column += count;
    }
    return columns;
}

} // namespace

Packing readXyz(TextLines lines, double radius)
{
    Packing packing;
    for (std::string_view line; lines.next(line);)
    {
        const auto words = wordsOf(line);
        if (words.empty())
        {
            continue;
        }
        const std::size_t count = countOf(words.front(), lines);
        const SphereColumns columns = columnsOf(lines.need("its second line"), lines);
        columns.requireAll(lines, radius);
        packing = {}; // of several moments the last
        for (std::size_t k = 0; k < count; ++k)
        {
            const std::string_view atom = lines.need(fmt::format("its {} spheres", count));
            addSphere(wordsOf(atom), columns, radius, lines, packing);
        }
    }
    packing.format = "XYZ";
    return packing;
}

} // namespace frostfill

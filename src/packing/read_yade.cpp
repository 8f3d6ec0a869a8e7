// SPDX-License-Identifier: MIT
// What yade.export.text and textExt write. The first line names the columns: #format x_y_z_r_matId.
#include "packing/timestep.hpp"
#include "packing/timestep_reader.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr std::string_view kFormatMark = "#format";

} // namespace

bool isYade(std::string_view text)
{
    return text.starts_with(kFormatMark) && text.substr(kFormatMark.size()).starts_with(' ');
}

Timestep readYade(TextLines lines, double radius)
{
    const auto words = wordsOf(lines.need("its format").substr(kFormatMark.size()));
    if (words.size() != 1)
    {
        lines.refuse("'#format' needs the names of the columns behind it, such as x_y_z_r");
    }
    SphereColumns columns;
    int index = 0;
    for (const std::string_view name : wordsOf(words.front(), '_'))
    {
        columns.take(name, index++);
    }
    columns.keepPlacesOnly();
    columns.requireAll(lines, radius);
    Timestep timestep;
    for (std::string_view line; lines.next(line);)
    {
        const auto sphere = wordsOf(line);
        if (!sphere.empty() && !sphere.front().starts_with('#'))
        {
            addSphere(sphere, columns, radius, lines, timestep);
        }
    }
    return timestep;
}

} // namespace frostfill

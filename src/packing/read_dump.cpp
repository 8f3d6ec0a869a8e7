// SPDX-License-Identifier: MIT
#include "packing/text_lines.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr std::string_view kItem = "ITEM: ";
constexpr std::string_view kAtoms = "ATOMS";

SphereColumns columnsOf(std::string_view names, const TextLines& lines)
{
    SphereColumns columns;
    int index = 0;
    bool scaled = false;
    for (const std::string_view name : wordsOf(names))
    {
        scaled = scaled || name == "xs" || name == "xsu";
        columns.take(name, index++);
    }
    if (scaled && columns.x < 0)
    {
        lines.refuse("places as fractions of the box (xs ys zs); dump x y z instead");
    }
    return columns;
}

} // namespace

Packing readDump(TextLines lines, double radius)
{
    Packing packing;
    std::size_t count = 0;
    for (std::string_view line; lines.next(line);)
    {
        if (!line.starts_with(kItem))
        {
            continue; // of a part that says nothing of the spheres
        }
        line.remove_prefix(kItem.size());
        if (line.starts_with("NUMBER OF ATOMS"))
        {
            const auto words = wordsOf(lines.need("the number of atoms"));
            count = countOf(words.empty() ? "" : words.front(), lines);
        }
        else if (line.starts_with(kAtoms))
        {
            const SphereColumns columns = columnsOf(line.substr(kAtoms.size()), lines);
            columns.requireAll(lines, radius);
            packing = {}; // of several moments the last
            for (std::size_t k = 0; k < count; ++k)
            {
                const std::string_view atom = lines.need(fmt::format("its {} spheres", count));
                addSphere(wordsOf(atom), columns, radius, lines, packing);
            }
        }
    }
    packing.format = "a LAMMPS dump";
    return packing;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
// Data files of LAMMPS and LIGGGHTS (write_data, read_data). The first line is a comment; a head
// and sections follow, of which only Atoms is read.
#include "packing/timestep.hpp"
#include "packing/timestep_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace frostfill
{
namespace
{

/// The number of atoms is among the first lines. [1] Larger: a large file of another kind is
/// searched for longer. Smaller: a head with many blank lines is not recognised.
constexpr int kLinesOfHead = 32;

std::string_view withoutComment(std::string_view line)
{
    return line.substr(0, line.find('#'));
}

/// The number before "atoms", if the line says that alone.
std::optional<std::string_view> atomsOf(std::string_view line)
{
    const auto words = wordsOf(withoutComment(line));
    const bool says = words.size() == 2 && words[1] == "atoms";
    return says ? std::optional(words[0]) : std::nullopt;
}

/// The columns of an atom_style; the section says behind a # which it is, or nothing.
SphereColumns columnsOfStyle(std::string_view style, const TextLines& lines)
{
    const char* names = style.empty() || style == "sphere" || style == "granular"
                            ? "id type diameter density x y z"
                        : style == "bpm/sphere" ? "id molecule type diameter density x y z"
                        : style == "atomic"     ? "id type x y z"
                                                : nullptr;
    if (names == nullptr)
    {
        lines.refuse(
            fmt::format("atoms of the style '{}'; sphere, bpm/sphere and atomic are read", style));
    }
    SphereColumns columns;
    int index = 0;
    for (const std::string_view name : wordsOf(names))
    {
        columns.take(name, index++);
    }
    return columns;
}

} // namespace

bool isLammpsData(std::string_view text)
{
    TextLines lines(text, "");
    std::string_view line;
    for (int k = 0; k < kLinesOfHead && lines.next(line); ++k)
    {
        if (k > 0 && atomsOf(line))
        {
            return true;
        }
    }
    return false;
}

Timestep readLammpsData(TextLines lines, double radius)
{
    (void)lines.need("its head"); // a comment, whatever it says
    std::size_t count = 0;
    std::vector<std::string_view> section;
    while (section.empty() || section.front() != "Atoms")
    {
        const std::string_view line = lines.need("its section Atoms");
        section = wordsOf(line);
        if (const auto atoms = atomsOf(line))
        {
            count = countOf(*atoms, lines);
        }
    }
    const bool saysStyle = section.size() == 3 && section[1] == "#";
    const SphereColumns columns = columnsOfStyle(saysStyle ? section[2] : "", lines);
    columns.requireAll(lines, radius);
    Timestep timestep;
    while (timestep.centres.size() < count)
    {
        const auto words = wordsOf(withoutComment(lines.need(fmt::format("its {} atoms", count))));
        if (!words.empty())
        {
            addSphere(words, columns, radius, lines, timestep);
        }
    }
    return timestep;
}

} // namespace frostfill

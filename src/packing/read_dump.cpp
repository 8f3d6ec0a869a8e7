// SPDX-License-Identifier: MIT
// Dumps of LAMMPS (dump custom) and of LIGGGHTS, which has the same form and repeats columns.
#include "packing/timestep.hpp"

#include <fmt/format.h>

namespace frostfill
{
namespace
{

constexpr std::string_view kItem = "ITEM: ";
constexpr std::string_view kAtoms = "ATOMS";
constexpr std::string_view kBox = "BOX BOUNDS";

SphereColumns columnsOf(std::string_view names, const TextLines& lines, const Timestep& timestep)
{
    SphereColumns columns;
    int index = 0;
    for (const std::string_view name : wordsOf(names))
    {
        columns.take(name, index++);
    }
    const bool scaled = (columns.x < 0 && columns.scaledX >= 0) ||
                        (columns.y < 0 && columns.scaledY >= 0) ||
                        (columns.z < 0 && columns.scaledZ >= 0);
    if (scaled && !timestep.box)
    {
        lines.refuse("places as fractions (xs ys zs) of a box that is tilted or not given; dump "
                     "x y z instead");
    }
    return columns;
}

std::string_view firstWord(TextLines& lines, std::string_view what)
{
    const auto words = wordsOf(lines.need(what));
    return words.empty() ? std::string_view() : words.front();
}

/// Three lines follow, with the low and the high end of an axis. A tilted box has more on a line.
std::optional<Eigen::AlignedBox3d> boxOf(TextLines& lines)
{
    Eigen::AlignedBox3d box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    bool upright = true;
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto words = wordsOf(lines.need("the bounds of its box"));
        upright = upright && words.size() == 2;
        if (words.size() < 2)
        {
            lines.refuse("two bounds of the box are needed");
        }
        box.min()[axis] = numberOf(words[0], lines);
        box.max()[axis] = numberOf(words[1], lines);
    }
    return upright ? std::optional(box) : std::nullopt;
}

void readSpheres(TextLines& lines, std::string_view names, std::size_t count, double radius,
                 Timestep& timestep)
{
    const SphereColumns columns = columnsOf(names, lines, timestep);
    columns.requireAll(lines, radius);
    for (std::size_t k = 0; k < count; ++k)
    {
        const std::string_view sphere = lines.need(fmt::format("its {} spheres", count));
        if (sphere.starts_with(kItem))
        {
            lines.refuse(fmt::format("the next part begins after {} of {} spheres", k, count));
        }
        addSphere(wordsOf(sphere), columns, radius, lines, timestep);
    }
}

} // namespace

bool readDumpTimestep(TextLines& lines, double radius, Timestep& timestep)
{
    timestep = {};
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
            count = countOf(firstWord(lines, "the number of atoms"), lines);
        }
        else if (line == "TIMESTEP")
        {
            timestep.step = wholeNumberOf(firstWord(lines, "the number of the step"), lines);
        }
        else if (line == "TIME")
        {
            timestep.time = numberOf(firstWord(lines, "the time"), lines);
        }
        else if (line.starts_with(kBox))
        {
            timestep.box = boxOf(lines);
        }
        else if (line.starts_with(kAtoms))
        {
            readSpheres(lines, line.substr(kAtoms.size()), count, radius, timestep);
            return true;
        }
    }
    return false;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
// XYZ, plain or extended (Lattice="..." Properties=... Time=...), as ASE and OVITO write it.
#include "packing/timestep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace frostfill
{
namespace
{

/// What stands behind `key=` in the second line, without quotes; in any case of letters.
std::optional<std::string_view> valueOf(std::string_view comment, std::string_view key)
{
    const auto equal = [](char a, char b)
    {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    for (auto from = comment.begin();;)
    {
        const auto at = std::search(from, comment.end(), key.begin(), key.end(), equal);
        if (at == comment.end())
        {
            return std::nullopt;
        }
        const auto after = at + static_cast<std::ptrdiff_t>(key.size());
        const bool begins = at == comment.begin() || *(at - 1) == ' ' || *(at - 1) == '\t';
        if (begins && after != comment.end() && *after == '=')
        {
            std::string_view value =
                comment.substr(static_cast<std::size_t>(after - comment.begin()) + 1);
            const bool quoted = value.starts_with('"');
            value.remove_prefix(quoted ? 1 : 0);
            return value.substr(0, value.find_first_of(quoted ? "\"" : " \t"));
        }
        from = at + 1;
    }
}

/// The columns that Properties=species:S:1:pos:R:3:radius:R:1 names; plain XYZ has a species and a
/// place.
SphereColumns columnsOf(std::string_view comment, const TextLines& lines)
{
    const auto parts = wordsOf(valueOf(comment, "Properties").value_or("species:S:1:pos:R:3"), ':');
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
        else if ((parts[i] == "velo" || parts[i] == "vel") && count == 3)
        {
            columns.velocityX = column;
            columns.velocityY = column + 1;
            columns.velocityZ = column + 2;
        }
        else if (count == 1 && (parts[i + 1] != "S" || parts[i] == "state")) // S: words
        {
            columns.take(parts[i], column);
        }
        column += count;
    }
    return columns;
}

/// The box of a lattice whose vectors lie along the axes.
std::optional<Eigen::AlignedBox3d> boxOf(std::string_view comment, const TextLines& lines)
{
    const auto lattice = wordsOf(valueOf(comment, "Lattice").value_or(""));
    const auto origin = wordsOf(valueOf(comment, "Origin").value_or("0 0 0"));
    if (lattice.size() != 9 || origin.size() != 3)
    {
        return std::nullopt;
    }
    Eigen::AlignedBox3d box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < lattice.size(); ++i)
    {
        const double value = numberOf(lattice[i], lines);
        const auto axis = static_cast<Eigen::Index>(i % 3);
        if (i % 4 == 0)
        {
            box.min()[axis] = numberOf(origin[i % 3], lines);
            box.max()[axis] = box.min()[axis] + value;
        }
        else if (value != 0)
        {
            return std::nullopt;
        }
    }
    return box;
}

void readHeading(std::string_view comment, const TextLines& lines, Timestep& timestep)
{
    if (const auto time = valueOf(comment, "Time"))
    {
        timestep.time = numberOf(*time, lines);
    }
    for (const char* key : {"Timestep", "step"})
    {
        if (const auto step = valueOf(comment, key); step && !timestep.step)
        {
            timestep.step = wholeNumberOf(*step, lines);
        }
    }
    timestep.box = boxOf(comment, lines);
}

} // namespace

bool readXyzTimestep(TextLines& lines, double radius, Timestep& timestep)
{
    timestep = {};
    for (std::string_view line; lines.next(line);)
    {
        const auto words = wordsOf(line);
        if (words.empty())
        {
            continue;
        }
        const std::size_t count = countOf(words.front(), lines);
        const std::string_view comment = lines.need("its second line");
        const SphereColumns columns = columnsOf(comment, lines);
        columns.requireAll(lines, radius);
        readHeading(comment, lines, timestep);
        for (std::size_t k = 0; k < count; ++k)
        {
            const std::string_view sphere = lines.need(fmt::format("its {} spheres", count));
            addSphere(wordsOf(sphere), columns, radius, lines, timestep);
        }
        return true;
    }
    return false;
}

} // namespace frostfill

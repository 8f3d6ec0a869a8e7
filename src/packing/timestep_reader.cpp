// SPDX-License-Identifier: MIT
#include "packing/timestep_reader.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace frostfill
{

bool isXyz(std::string_view text)
{
    const auto words = wordsOf(text.substr(0, text.find_first_of("\r\n")));
    return words.size() == 1 && !words.front().empty() &&
           std::all_of(words.front().begin(), words.front().end(),
                       [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool isDump(std::string_view text)
{
    return text.starts_with("ITEM: ");
}

TimestepReader::TimestepReader(const std::filesystem::path& file, double radius)
    : name_(file.string()), mapped_(file), lines_(mapped_.bytes(), name_), radius_(radius),
      isDump_(frostfill::isDump(mapped_.bytes()))
{
    if (!isDump_ && !isXyz(mapped_.bytes()))
    {
        throw Error(ErrorCode::badData,
                    fmt::format("'{}' is no LAMMPS or LIGGGHTS dump and no XYZ", name_));
    }
}

bool TimestepReader::read(Timestep& timestep)
{
    const bool found = isDump_ ? readDumpTimestep(lines_, radius_, timestep)
                               : readXyzTimestep(lines_, radius_, timestep);
    if (found ? lines_.cut() : timestep.step || timestep.time)
    {
        torn_ = found ? "its last line is incomplete" : "it ends within a heading";
        return false;
    }
    return found;
}

bool TimestepReader::next(Timestep& timestep)
{
    try
    {
        if (!read(timestep))
        {
            return false;
        }
    }
    catch (const Error& error)
    {
        if (error.code() != ErrorCode::badData || !lines_.cut())
        {
            throw;
        }
        torn_ = error.what();
        return false;
    }
    examine(timestep);
    return true;
}

void TimestepReader::examine(const Timestep& timestep) const
{
    const auto name = [&](std::size_t k)
    {
        return timestep.ids.empty() ? fmt::format("sphere {} of this step", k + 1)
                                    : fmt::format("sphere {}", timestep.ids[k]);
    };
    for (std::size_t k = 0; k < timestep.centres.size(); ++k)
    {
        if (!timestep.centres[k].allFinite())
        {
            lines_.refuse(fmt::format("the position of {} is not a number", name(k)));
        }
        if (!timestep.speeds.empty() && !std::isfinite(timestep.speeds[k]))
        {
            lines_.refuse(fmt::format("the velocity of {} is not a number", name(k)));
        }
    }
    std::vector<std::uint64_t> ids = timestep.ids;
    std::sort(ids.begin(), ids.end());
    if (const auto twice = std::adjacent_find(ids.begin(), ids.end()); twice != ids.end())
    {
        lines_.refuse(fmt::format("sphere {} is there twice", *twice));
    }
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "packing/timestep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <string>

namespace frostfill
{
namespace
{

std::string lowered(std::string_view word)
{
    std::string low(word);
    std::transform(low.begin(), low.end(), low.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return low;
}

/// By name or number, as in files of ours; any other word means that it rests.
SphereState stateOf(std::string_view word)
{
    return word == "running" || word == "0"     ? SphereState::running
           : word == "discarded" || word == "2" ? SphereState::discarded
                                                : SphereState::frozen;
}

} // namespace

void SphereColumns::take(std::string_view name, int index)
{
    const std::string low = lowered(name);
    const auto is = [&](std::initializer_list<const char*> names)
    { return std::find(names.begin(), names.end(), low) != names.end(); };
    int* column = is({"x", "xu", "pos_x", "position_x", "p_x", "points:0"})   ? &x
                  : is({"y", "yu", "pos_y", "position_y", "p_y", "points:1"}) ? &y
                  : is({"z", "zu", "pos_z", "position_z", "p_z", "points:2"}) ? &z
                  : is({"xs", "xsu"})                                         ? &scaledX
                  : is({"ys", "ysu"})                                         ? &scaledY
                  : is({"zs", "zsu"})                                         ? &scaledZ
                  : is({"radius", "r", "rad"})                                ? &radius
                  : is({"diameter", "d", "diameters"})                        ? &diameter
                  : is({"id"})                                                ? &id
                  : is({"state"})                                             ? &state
                  : is({"group"})                                             ? &group
                  : is({"vx"})                                                ? &velocityX
                  : is({"vy"})                                                ? &velocityY
                  : is({"vz"})                                                ? &velocityZ
                  : is({"speed"})                                             ? &speed
                                                                              : nullptr;
    if (column != nullptr && *column < 0)
    {
        *column = index;
    }
    if (const Column* known = findColumn(low); known != nullptr && known->isCarried())
    {
        carried.try_emplace(known, index);
    }
}

void SphereColumns::requireAll(const TextLines& lines, double given) const
{
    const bool hasX = x >= 0 || scaledX >= 0;
    const bool hasY = y >= 0 || scaledY >= 0;
    const bool hasZ = z >= 0 || scaledZ >= 0;
    if (!hasX || !hasY || !hasZ)
    {
        lines.refuse(fmt::format("no column {}: the columns x, y and z are needed, and radius",
                                 !hasX   ? "x"
                                 : !hasY ? "y"
                                         : "z"));
    }
    if (radius < 0 && diameter < 0 && given <= 0)
    {
        lines.refuse("no column radius: if all spheres have one radius, give it with --radius");
    }
}

std::size_t SphereColumns::width() const
{
    int last = std::max({x, y, z, scaledX, scaledY, scaledZ, radius, diameter, id, state, group,
                         velocityX, velocityY, velocityZ, speed});
    for (const auto& [column, index] : carried)
    {
        last = std::max(last, index);
    }
    return static_cast<std::size_t>(last) + 1;
}

void addSphere(const std::vector<std::string_view>& words, const SphereColumns& columns,
               double radius, const TextLines& lines, Timestep& timestep)
{
    if (words.size() < columns.width())
    {
        lines.refuse(fmt::format("{} values, where {} are needed", words.size(), columns.width()));
    }
    const auto word = [&](int column) { return words[static_cast<std::size_t>(column)]; };
    const auto number = [&](int column) { return numberOf(word(column), lines); };
    const auto place = [&](int plain, int scaled, int axis)
    {
        return plain >= 0
                   ? number(plain)
                   : timestep.box->min()[axis] + number(scaled) * timestep.box->sizes()[axis];
    };
    timestep.centres.emplace_back(place(columns.x, columns.scaledX, 0),
                                  place(columns.y, columns.scaledY, 1),
                                  place(columns.z, columns.scaledZ, 2));
    timestep.radii.push_back(columns.radius >= 0     ? number(columns.radius)
                             : columns.diameter >= 0 ? number(columns.diameter) / 2
                                                     : radius);
    const double size = timestep.radii.back();
    if (!(size > 0) || !std::isfinite(size))
    {
        const bool isDiameter = columns.radius < 0 && columns.diameter >= 0;
        lines.refuse(fmt::format("the {} of sphere {} is {}, not above 0",
                                 isDiameter ? "diameter" : "radius",
                                 columns.id >= 0 ? std::string(word(columns.id))
                                                 : fmt::format("{}", timestep.radii.size()),
                                 isDiameter ? 2 * size : size));
    }
    if (columns.id >= 0)
    {
        timestep.ids.push_back(wholeNumberOf(word(columns.id), lines));
    }
    if (columns.state >= 0)
    {
        timestep.states.push_back(stateOf(word(columns.state)));
    }
    if (columns.group >= 0)
    {
        timestep.groups.push_back(
            static_cast<std::uint32_t>(wholeNumberOf(word(columns.group), lines)));
    }
    for (const auto& [column, index] : columns.carried)
    {
        timestep.carried[column].push_back(
            column->isWhole() ? static_cast<double>(wholeNumberOf(word(index), lines))
                              : number(index));
    }
    if (columns.speed >= 0)
    {
        timestep.speeds.push_back(number(columns.speed));
    }
    else if (columns.velocityX >= 0 && columns.velocityY >= 0 && columns.velocityZ >= 0)
    {
        timestep.speeds.push_back(Eigen::Vector3d(number(columns.velocityX),
                                                  number(columns.velocityY),
                                                  number(columns.velocityZ))
                                      .norm());
    }
}

} // namespace frostfill

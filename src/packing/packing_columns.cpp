// SPDX-License-Identifier: MIT
#include <frostfill/error.hpp>
#include <frostfill/options.hpp>
#include <frostfill/packing.hpp>

#include <fmt/format.h>

#include <array>
#include <utility>

namespace frostfill
{
namespace
{

constexpr std::array<std::pair<const char*, std::string PackingColumns::*>, 5> kQuantities = {
    {{"x", &PackingColumns::x},
     {"y", &PackingColumns::y},
     {"z", &PackingColumns::z},
     {"radius", &PackingColumns::radius},
     {"diameter", &PackingColumns::diameter}}};

std::string& columnOf(std::string_view quantity, PackingColumns& columns)
{
    std::vector<std::string> names;
    for (const auto& [name, member] : kQuantities)
    {
        if (quantity == name)
        {
            return columns.*member;
        }
        names.emplace_back(name);
    }
    const std::string nearest = nearestName(quantity, names);
    throw Error(ErrorCode::usage,
                fmt::format("'{}' is no quantity of a sphere; {}", quantity,
                            nearest.empty() ? "columns are given for x, y, z, radius or diameter"
                                            : fmt::format("did you mean {}?", nearest)));
}

} // namespace

PackingColumns parsePackingColumns(std::string_view text)
{
    PackingColumns columns;
    for (std::string_view rest = text;;)
    {
        const std::string_view part = rest.substr(0, rest.find(','));
        const std::size_t equal = part.find('=');
        if (equal == std::string_view::npos || equal + 1 == part.size())
        {
            throw Error(ErrorCode::usage,
                        fmt::format("'{}' names no column; write x=NAME,y=NAME,z=NAME,radius=NAME "
                                    "with names or numbers of columns",
                                    part));
        }
        std::string& column = columnOf(part.substr(0, equal), columns);
        if (!column.empty())
        {
            throw Error(ErrorCode::usage,
                        fmt::format("the column of {} is given twice", part.substr(0, equal)));
        }
        column = part.substr(equal + 1);
        if (part.size() == rest.size())
        {
            break;
        }
        rest.remove_prefix(part.size() + 1);
    }
    if (!columns.radius.empty() && !columns.diameter.empty())
    {
        throw Error(ErrorCode::usage, "columns for radius and diameter are both given; leave out "
                                      "one");
    }
    return columns;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "scene/options/nearest_name.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace frostfill
{

std::size_t editDistance(std::string_view a, std::string_view b)
{
    // row[j] is the distance of the part of `a` seen so far from the first j letters of `b`.
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::string nearestName(std::string_view name, std::span<const std::string> names)
{
    // The dashes of an option are no resemblance.
    const std::size_t letters = name.size() - std::min(name.find_first_not_of('-'), name.size());
    std::string nearest;
    std::size_t smallest = letters / 2 + 1;
    for (const std::string& candidate : names)
    {
        const std::size_t distance = editDistance(name, candidate);
        if (distance < smallest)
        {
            smallest = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "fps/paper_numbers.hpp"

#include <fmt/format.h>

namespace frostfill
{

std::string rangeText(const PaperRange& range)
{
    return range.low == range.high ? fmt::format("{:g}", range.low)
                                   : fmt::format("{:g}–{:g}", range.low, range.high);
}

const PaperNumbers* paperNumbers(std::string_view object)
{
    static const std::vector<PaperNumbers> kPaper = {
        {"torus", {{13, 25}, {26, 50}}, 51, {5, 10}},
        {"sphere", {{23, 23}, {35, 35}}, 0.4, {10, 10}},
        {"cube", {{17, 17}, {35, 35}}, 0.8, {10, 10}},
        {"human", {{13, 13}, {26, 26}, {39, 39}}, 0.6, {5, 10}},
    };
    for (const PaperNumbers& numbers : kPaper)
    {
        if (numbers.object == object)
        {
            return &numbers;
        }
    }
    return nullptr;
}

} // namespace frostfill

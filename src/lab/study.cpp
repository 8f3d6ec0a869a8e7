// SPDX-License-Identifier: MIT
#include "lab/study.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace frostfill
{

double ErrorStudy::detail(const ErrorPoint& point, const std::string& detailName) const
{
    for (std::size_t k = 0; k < details.size(); ++k)
    {
        if (details[k] == detailName)
        {
            return point.details.at(k);
        }
    }
    throw std::out_of_range(detailName);
}

Table errorCsv(const ErrorStudy& study)
{
    Table table;
    table.headings = {"curve", "setting", "rivals", "seconds", "error", "default"};
    table.headings.insert(table.headings.end(), study.details.begin(), study.details.end());
    for (const ErrorPoint& point : study.points)
    {
        std::vector<std::string> row = {point.curve,
                                        point.setting,
                                        point.rivals,
                                        fmt::format("{:.4f}", point.seconds),
                                        fmt::format("{:.4e}", point.error),
                                        point.isDefault ? "1" : "0"};
        for (const double detail : point.details)
        {
            row.push_back(fmt::format("{:.6g}", detail));
        }
        table.rows.push_back(row);
    }
    return table;
}

Table errorTable(const ErrorStudy& study)
{
    Table table;
    table.title = fmt::format("{}: time against {}", study.name, study.error);
    table.words = 2;
    table.headings = {"method", "setting", "seconds", "error"};
    for (const ErrorPoint& point : study.points)
    {
        table.rows.push_back({point.curve, point.setting + (point.isDefault ? " (default)" : ""),
                              fmt::format("{:.3f}", point.seconds),
                              fmt::format("{:.2e}", point.error)});
    }
    return table;
}

} // namespace frostfill

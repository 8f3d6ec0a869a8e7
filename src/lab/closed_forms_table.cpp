// SPDX-License-Identifier: MIT
#include "lab/closed_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Slope of log |error| against log value; NaN where an error is zero or only rounding.
double orderOf(const std::vector<const ClosedFormPoint*>& points)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const ClosedFormPoint* point : points)
    {
        if (std::abs(point->error) < kClosedFormRounding)
        {
            continue;
        }
        const double x = std::log(point->value);
        const double y = std::log(std::abs(point->error));
        ++n;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    return n > 2 && spread > 0 ? (n * sxy - sx * sy) / spread : std::nan("");
}

} // namespace

bool ClosedFormPoint::holds() const
{
    return exact ? std::abs(error - expected) <= kClosedFormRounding * 100
                 : std::abs(error) <= std::abs(expected);
}

Table closedFormsCsv(const std::vector<ClosedFormPoint>& points)
{
    Table table;
    table.headings = {"problem", "method",    "parameter", "value",
                      "error",   "magnitude", "expected",  "holds"};
    for (const ClosedFormPoint& point : points)
    {
        table.rows.push_back({point.problem, point.method, point.parameter,
                              fmt::format("{:g}", point.value), fmt::format("{:.6e}", point.error),
                              fmt::format("{:.6e}", std::abs(point.error)),
                              fmt::format("{:.6e}", point.expected), point.holds() ? "1" : "0"});
    }
    return table;
}

Table closedFormsTable(const std::vector<ClosedFormPoint>& points)
{
    Table table;
    table.title = "Errors against closed forms (r = 1, g = 1)";
    table.words = 3;
    table.headings = {"problem", "method", "varied", "from", "to",
                      "error",   "error",  "order",  "holds"};
    for (std::size_t k = 0; k < points.size(); ++k)
    {
        const auto same = [&](const ClosedFormPoint& other)
        { return other.problem == points[k].problem && other.method == points[k].method; };
        if (std::find_if(points.begin(), points.end(), same) - points.begin() !=
            static_cast<std::ptrdiff_t>(k))
        {
            continue;
        }
        std::vector<const ClosedFormPoint*> curve;
        for (const ClosedFormPoint& other : points)
        {
            if (same(other))
            {
                curve.push_back(&other);
            }
        }
        const bool holds = std::all_of(curve.begin(), curve.end(),
                                       [](const auto* point) { return point->holds(); });
        const double order = orderOf(curve);
        table.rows.push_back(
            {points[k].problem, points[k].method, points[k].parameter,
             fmt::format("{:g}", curve.front()->value), fmt::format("{:g}", curve.back()->value),
             fmt::format("{:.2e}", curve.front()->error),
             fmt::format("{:.2e}", curve.back()->error),
             std::isnan(order) ? "-" : fmt::format("{:.2f}", order), holds ? "yes" : "NO"});
    }
    return table;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/quality/size_report.hpp"

#include "scene/size_ledger.hpp"

namespace frostfill
{

std::optional<SizeReport> sizeReport(const World& world)
{
    if (!world.radii.curve())
    {
        return std::nullopt;
    }
    SizeLedger ledger(*world.radii.curve());
    for (std::uint32_t id = 0; id < world.spheres.size(); ++id)
    {
        ledger.add(world.spheres.radius(id));
    }
    SizeReport report;
    const std::vector<double>& sieves = ledger.sieves();
    for (std::size_t k = 0; k < sieves.size(); ++k)
    {
        const auto [asked, achieved] = ledger.mass(k);
        const auto [askedNumber, achievedNumber] = ledger.number(k);
        report.points.push_back(
            {sieves[k] * world.frame.length, asked, achieved, askedNumber, achievedNumber});
    }
    report.deviation = ledger.deviation();
    report.at = report.points[ledger.worst()].radius;
    return report;
}

} // namespace frostfill

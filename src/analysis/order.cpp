// SPDX-License-Identifier: MIT
#include "analysis/analysis_input.hpp"
#include "analysis/bond_order.hpp"

namespace frostfill
{
namespace
{

BondOrder6 bondsOf(const AnalysisInput& input, std::size_t k)
{
    const double radius = input.radii[k];
    const double share = input.settings.bondLength;
    BondOrder6 order;
    input.forEachNear(
        input.centres[k], [&](double largest) { return share * (radius + largest); },
        [&](std::uint32_t other, const Eigen::Vector3d& centre, double its)
        {
            const Eigen::Vector3d apart = centre - input.centres[k];
            const double square = apart.squaredNorm();
            const double longest = share * (radius + its);
            if (square <= longest * longest && square > 0 && other != k)
            {
                order.add(apart / std::sqrt(square));
            }
        });
    return order;
}

} // namespace

OrderStatistics findOrder(const AnalysisInput& input)
{
    struct Part
    {
        BondOrder6 all;
        double sum = 0;
        std::size_t inside = 0;
    };
    OrderStatistics statistics;
    statistics.q6.resize(input.size());
    statistics.bonds.resize(input.size());
    std::vector<Part> parts(input.parts());
    input.forEachPartOfSpheres(
        [&](std::size_t first, std::size_t end, std::size_t part)
        {
            for (const std::uint32_t k : input.levels.order().subspan(first, end - first))
            {
                const BondOrder6 order = bondsOf(input, k);
                statistics.q6[k] = order.q6();
                statistics.bonds[k] = static_cast<std::uint32_t>(order.bonds());
                if (input.isAwayFromWalls(k))
                {
                    parts[part].all.add(order);
                    parts[part].sum += statistics.q6[k];
                    ++parts[part].inside;
                }
            }
        });
    Part all;
    for (const Part& part : parts)
    {
        all.all.add(part.all);
        all.sum += part.sum;
        all.inside += part.inside;
    }
    statistics.inside = all.inside;
    statistics.mean =
        all.inside > 0 ? all.sum / static_cast<double>(all.inside) : AnalysisInput::kNothing;
    statistics.global = all.inside > 0 ? all.all.q6() : AnalysisInput::kNothing;
    return statistics;
}

} // namespace frostfill

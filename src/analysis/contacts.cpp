// SPDX-License-Identifier: MIT
#include "analysis/analysis_input.hpp"
#include "simulation/quality/quality.hpp"

#include <algorithm>
#include <utility>

namespace frostfill
{
namespace
{

/// Contacts of a sphere with those behind it in the lists, ascending.
void addContacts(const AnalysisInput& input, std::uint32_t k, std::vector<SphereContact>& network)
{
    const auto begin = static_cast<std::ptrdiff_t>(network.size());
    const double radius = input.radii[k];
    const double share = input.settings.contactGap;
    input.forEachNear(
        input.centres[k],
        [&](double largest) { return radius + largest + share * std::min(radius, largest); },
        [&](std::uint32_t other, const Eigen::Vector3d& centre, double its)
        {
            if (other <= k)
            {
                return;
            }
            const double gap = (centre - input.centres[k]).norm() - radius - its;
            if (gap < share * std::min(radius, its))
            {
                network.push_back({k, other, gap});
            }
        });
    std::sort(network.begin() + begin, network.end(),
              [](const SphereContact& a, const SphereContact& b) { return a.second < b.second; });
}

std::vector<SphereContact> networkOf(const AnalysisInput& input)
{
    std::vector<std::vector<SphereContact>> parts(input.parts());
    input.forEachPartOfSpheres(
        [&](std::size_t first, std::size_t end, std::size_t part)
        {
            for (std::size_t k = first; k < end; ++k)
            {
                addContacts(input, static_cast<std::uint32_t>(k), parts[part]);
            }
        });
    std::vector<SphereContact> network;
    for (const std::vector<SphereContact>& part : parts)
    {
        network.insert(network.end(), part.begin(), part.end());
    }
    return network;
}

/// Takes away what has too few contacts, again and again. Walls stay.
void findRattlers(ContactStatistics& statistics, std::uint32_t fewest)
{
    const std::size_t count = statistics.spheres.size();
    std::vector<std::uint32_t> starts(count + 1, 0);
    for (std::size_t k = 0; k < count; ++k)
    {
        starts[k + 1] = starts[k] + statistics.spheres[k];
    }
    std::vector<std::uint32_t> others(2 * statistics.network.size());
    std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
    for (const SphereContact& contact : statistics.network)
    {
        others[next[contact.first]++] = contact.second;
        others[next[contact.second]++] = contact.first;
    }
    std::vector<std::uint32_t> held(count);
    std::vector<std::uint32_t> loose;
    const auto look = [&](std::uint32_t k)
    {
        if (held[k] < fewest && statistics.rattler[k] == 0)
        {
            statistics.rattler[k] = 1;
            loose.push_back(k);
        }
    };
    for (std::uint32_t k = 0; k < count; ++k)
    {
        held[k] = statistics.spheres[k] + statistics.walls[k];
    }
    for (std::uint32_t k = 0; k < count; ++k)
    {
        look(k);
    }
    while (!loose.empty())
    {
        const std::uint32_t gone = loose.back();
        loose.pop_back();
        for (std::uint32_t place = starts[gone]; place < starts[gone + 1]; ++place)
        {
            --held[others[place]];
            look(others[place]);
        }
    }
}

/// Contacts that are wider than the judge's carry nothing.
void findForces(ContactStatistics& statistics, const AnalysisInput& input)
{
    const ContactForces found = forcesBetween(
        input.container.mesh(), input.centres, input.radii, input.settings.up,
        {.friction = *input.settings.forces, .rollingFriction = input.rollingFriction});
    statistics.unbalance = found.missing;
    for (const auto& [upon, from, force] : found.pairs)
    {
        const auto [first, second] = std::minmax(upon, from);
        const auto at = std::lower_bound(statistics.network.begin(), statistics.network.end(),
                                         std::pair(first, second),
                                         [](const SphereContact& a, const auto& ids)
                                         { return std::pair(a.first, a.second) < ids; });
        if (at != statistics.network.end() && at->first == first && at->second == second)
        {
            at->force = first == upon ? force : Eigen::Vector3d(-force);
        }
    }
}

double meanOf(double sum, std::size_t count)
{
    return count > 0 ? sum / static_cast<double>(count) : AnalysisInput::kNothing;
}

void findMeans(ContactStatistics& statistics, const AnalysisInput& input)
{
    double inside = 0;
    std::size_t countInside = 0;
    for (std::size_t k = 0; k < input.size(); ++k)
    {
        statistics.rattlers += statistics.rattler[k];
        if (input.isAwayFromWalls(k))
        {
            inside += statistics.spheres[k];
            ++countInside;
        }
    }
    std::size_t held = 0;
    for (const SphereContact& contact : statistics.network)
    {
        held += statistics.rattler[contact.first] + statistics.rattler[contact.second] == 0 ? 2 : 0;
    }
    statistics.mean = meanOf(2 * static_cast<double>(statistics.network.size()), input.size());
    statistics.meanInside = meanOf(inside, countInside);
    statistics.meanHeld = meanOf(static_cast<double>(held), input.size() - statistics.rattlers);
}

} // namespace

ContactStatistics findContacts(const AnalysisInput& input)
{
    ContactStatistics statistics;
    statistics.network = networkOf(input);
    statistics.spheres.assign(input.size(), 0);
    statistics.walls.assign(input.size(), 0);
    statistics.rattler.assign(input.size(), 0);
    for (const SphereContact& contact : statistics.network)
    {
        ++statistics.spheres[contact.first];
        ++statistics.spheres[contact.second];
    }
    input.forEachPartOfSpheres(
        [&](std::size_t first, std::size_t end, std::size_t)
        {
            for (std::size_t k = first; k < end; ++k)
            {
                const double reach = input.radii[k] * (1 + input.settings.contactGap);
                if (input.settings.bounds == AnalysisBounds::walls &&
                    input.wallDistances[k] <= reach)
                {
                    statistics.walls[k] = input.container.wallsWithin(input.centres[k], reach);
                }
            }
        });
    findRattlers(statistics, input.settings.rattlersBelow);
    findMeans(statistics, input);
    if (input.settings.forces)
    {
        findForces(statistics, input);
    }
    return statistics;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "analysis/analysis_input.hpp"
#include "analysis/porosity_samples.hpp"
#include "analysis/slabs.hpp"

#include <algorithm>
#include <array>

namespace frostfill
{
namespace
{

/// Parts of the height below which a slab counts as empty: what rounding leaves of one.
constexpr double kNoVolume = 1e-12;

std::vector<double> planesOf(const ProfileFrame& frame, std::size_t bins)
{
    std::vector<double> planes;
    const double foot = frame.box().min()[frame.up()];
    for (std::size_t k = 0; k <= bins; ++k)
    {
        planes.push_back(foot +
                         frame.tallest() * static_cast<double>(k) / static_cast<double>(bins));
    }
    return planes;
}

/// Volume of the spheres in each slab, by closed forms.
std::vector<double> sphereSlabs(const AnalysisInput& input, Eigen::Index axis,
                                const std::vector<double>& planes)
{
    const std::size_t bins = planes.size() - 1;
    const double width = (planes.back() - planes.front()) / static_cast<double>(bins);
    std::vector<std::vector<double>> parts(input.parts(), std::vector<double>(bins, 0.0));
    const auto slabOf = [&](double height)
    {
        const double slab = std::floor((height - planes.front()) / width);
        return static_cast<std::size_t>(std::clamp(slab, 0.0, static_cast<double>(bins - 1)));
    };
    input.forEachPartOfSpheres(
        [&](std::size_t first, std::size_t end, std::size_t part)
        {
            for (std::size_t k = first; k < end; ++k)
            {
                const double centre = input.centres[k][axis];
                const double radius = input.radii[k];
                const std::size_t last = slabOf(centre + radius);
                for (std::size_t slab = slabOf(centre - radius); slab <= last; ++slab)
                {
                    parts[part][slab] += ballBelow(radius, planes[slab + 1] - centre) -
                                         ballBelow(radius, planes[slab] - centre);
                }
            }
        });
    std::vector<double> sums(bins, 0.0);
    for (const std::vector<double>& part : parts)
    {
        std::transform(sums.begin(), sums.end(), part.begin(), sums.begin(), std::plus<>());
    }
    return sums;
}

/// Of the object, wherever the bed ends.
std::vector<PorosityBin> exactSlabs(const AnalysisInput& input, const ProfileFrame& frame)
{
    const std::vector<double> planes = planesOf(frame, input.settings.bins);
    const std::vector<double> object = meshSlabs(input.container.mesh(), frame.up(), planes);
    const std::vector<double> spheres = sphereSlabs(input, frame.up(), planes);
    std::vector<PorosityBin> bins;
    for (std::size_t k = 0; k < object.size(); ++k)
    {
        if (object[k] > kNoVolume * input.container.report().volume)
        {
            bins.push_back({planes[k] - planes.front(), planes[k + 1] - planes.front(),
                            1 - spheres[k] / object[k], 0, object[k]});
        }
    }
    return bins;
}

} // namespace

PorosityProfiles findPorosity(const AnalysisInput& input)
{
    const ProfileFrame frame(input);
    SampledPorosity sampled = samplePorosity(input, frame);
    PorosityProfiles& profiles = sampled.profiles;
    profiles.slabsAreExact = input.container.report().crossedTriangles == 0;
    if (profiles.slabsAreExact)
    {
        std::vector<PorosityBin> slabs = exactSlabs(input, frame);
        // Those that the surface cuts stay sampled.
        std::erase_if(slabs, [&](const PorosityBin& bin) { return bin.to > sampled.fullBelow; });
        std::copy_if(profiles.height.begin(), profiles.height.end(), std::back_inserter(slabs),
                     [&](const PorosityBin& bin) { return bin.to > sampled.fullBelow; });
        profiles.height = std::move(slabs);
    }
    return profiles;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "analysis/analysis_input.hpp"

#include <algorithm>
#include <functional>

namespace frostfill
{
namespace
{

std::vector<SizeBin> profileOf(const std::vector<double>& places, std::span<const double> radii,
                               double end, std::size_t count)
{
    std::vector<SizeBin> bins(count);
    const double width = end / static_cast<double>(count);
    const auto binOf = [&](double place)
    {
        const double bin = std::floor(place / width);
        return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(count - 1)));
    };
    for (std::size_t k = 0; k < places.size(); ++k)
    {
        SizeBin& bin = bins[binOf(places[k])];
        ++bin.spheres;
        bin.meanRadius += radii[k];
    }
    for (std::size_t k = 0; k < count; ++k)
    {
        bins[k].from = width * static_cast<double>(k);
        bins[k].to = width * static_cast<double>(k + 1);
        bins[k].meanRadius /= static_cast<double>(bins[k].spheres);
    }
    for (std::size_t k = 0; k < places.size(); ++k)
    {
        SizeBin& bin = bins[binOf(places[k])];
        bin.deviation += std::pow(radii[k] - bin.meanRadius, 2);
    }
    for (SizeBin& bin : bins)
    {
        bin.deviation = std::sqrt(bin.deviation / static_cast<double>(bin.spheres));
    }
    std::erase_if(bins, [](const SizeBin& bin) { return bin.spheres == 0; });
    return bins;
}

double correlation(const std::vector<double>& a, std::span<const double> b)
{
    const auto count = static_cast<double>(a.size());
    double meanA = 0;
    double meanB = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
    {
        meanA += a[k] / count;
        meanB += b[k] / count;
    }
    double both = 0;
    double ofA = 0;
    double ofB = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
    {
        both += (a[k] - meanA) * (b[k] - meanB);
        ofA += (a[k] - meanA) * (a[k] - meanA);
        ofB += (b[k] - meanB) * (b[k] - meanB);
    }
    return both / std::sqrt(ofA * ofB);
}

} // namespace

SizeProfiles findSizes(const AnalysisInput& input)
{
    const ProfileFrame frame(input);
    std::vector<double> heights;
    std::vector<double> distances;
    std::vector<double> radii;
    for (std::size_t k = 0; k < input.size(); ++k)
    {
        if (input.depths[k] >= 0)
        {
            heights.push_back(frame.height(input.centres[k]));
            distances.push_back(frame.radius(input.centres[k]));
            radii.push_back(input.radii[k]);
        }
    }
    SizeProfiles sizes;
    sizes.height = profileOf(heights, radii, frame.tallest(), input.settings.bins);
    sizes.radial = profileOf(distances, radii, frame.widest(), input.settings.bins);
    // Rounding would give equal spheres a correlation of its own.
    const bool equal =
        std::adjacent_find(radii.begin(), radii.end(), std::not_equal_to<>()) == radii.end();
    sizes.withHeight = equal ? AnalysisInput::kNothing : correlation(heights, radii);
    sizes.withRadial = equal ? AnalysisInput::kNothing : correlation(distances, radii);
    return sizes;
}

} // namespace frostfill

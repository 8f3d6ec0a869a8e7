// SPDX-License-Identifier: MIT
#include "analysis/analysis_input.hpp"

#include <algorithm>

namespace frostfill
{
namespace
{

/// Bins of a mean diameter.
constexpr double kPairBins = 50;
/// Share of the spheres, and number, that are at least as far from walls and surface as g(r)
/// reaches. Larger: a shorter range in narrow objects. Smaller: few spheres speak for all.
constexpr double kLeastShare = 0.01;
constexpr std::size_t kFewestCentres = 50;
/// Of more spheres that have room, so many speak for all, evenly spread. Larger: time. Smaller: of
/// bins of narrow shells the scatter is seen.
constexpr std::size_t kMostCentres = 100'000;

/// The range that was asked for, or the largest that leaves enough centres.
double rangeWithRoom(const AnalysisInput& input, double asked)
{
    const auto share = static_cast<std::size_t>(kLeastShare * static_cast<double>(input.size()));
    const std::size_t fewest = std::min(std::max(share, kFewestCentres), input.size());
    std::vector<double> distances;
    for (std::size_t k = 0; k < input.size(); ++k)
    {
        distances.push_back(input.room(k));
    }
    const auto nth = distances.end() - static_cast<std::ptrdiff_t>(fewest);
    std::nth_element(distances.begin(), nth, distances.end());
    // No farther than to the spheres' own images.
    return input.isPeriodic() ? std::min(asked, input.container.box().sizes().minCoeff())
                              : std::min(asked, *nth);
}

/// Counts of distances of neighbours of some centres.
class PairCounts
{
public:
    PairCounts(double range, double width)
        : range_(range), width_(width),
          counts_(static_cast<std::size_t>(std::lround(range / width)) + 1)
    {
    }

    void look(const SphereLevels& levels, const Eigen::Vector3d& centre)
    {
        for (const SphereLevels::Level& level : levels.levels())
        {
            level.forEachRange(centre, range_,
                               [&](std::uint32_t first, std::uint32_t end)
                               {
                                   for (std::uint32_t k = first; k < end; ++k)
                                   {
                                       const double square =
                                           (level.spheres[k].centre - centre).squaredNorm();
                                       if (square <= range_ * range_)
                                       {
                                           const double bin =
                                               std::sqrt(square) / width_ + 0.5; // the nearest
                                           ++counts_[static_cast<std::size_t>(bin)];
                                       }
                                   }
                               });
        }
    }
    void leaveOutItself() { --counts_.front(); }
    void add(const PairCounts& other)
    {
        std::transform(counts_.begin(), counts_.end(), other.counts_.begin(), counts_.begin(),
                       std::plus<>());
    }
    [[nodiscard]] const std::vector<std::uint64_t>& counts() const { return counts_; }

private:
    double range_;
    double width_;
    std::vector<std::uint64_t> counts_;
};

void fillBins(PairCorrelation& pairs, const std::vector<std::uint64_t>& counts, double width)
{
    std::uint64_t all = 0;
    for (const std::uint64_t count : counts)
    {
        all += count;
    }
    const auto centres = static_cast<double>(pairs.centres);
    pairs.numberDensity = (1 + static_cast<double>(all) / centres) / ballVolume(pairs.range);
    double sum = 0;
    for (std::size_t k = 0; k < counts.size(); ++k)
    {
        const double middle = width * static_cast<double>(k);
        const double from = std::max(0.0, middle - width / 2);
        const double to = std::min(pairs.range, middle + width / 2);
        const double shell = ballVolume(to) - ballVolume(from);
        const double found = static_cast<double>(counts[k]) / centres;
        sum += found;
        if (shell > 0)
        {
            pairs.bins.push_back({from, to, found / (shell * pairs.numberDensity), sum});
        }
    }
}

} // namespace

PairCorrelation findPairs(const AnalysisInput& input)
{
    PairCorrelation pairs;
    pairs.range = rangeWithRoom(input, input.settings.range * input.meanDiameter);
    const double width = input.meanDiameter / kPairBins;
    std::vector<std::uint32_t> centres;
    for (const std::uint32_t id : input.levels.order()) // so that near ones are looked at together
    {
        if (input.room(id) >= pairs.range)
        {
            centres.push_back(id);
        }
    }
    const std::size_t step = (centres.size() + kMostCentres - 1) / kMostCentres;
    for (std::size_t k = 0; k * step < centres.size(); ++k)
    {
        centres[k] = centres[k * step];
    }
    centres.resize((centres.size() + step - 1) / step);
    pairs.centres = centres.size();
    const std::size_t parts = (centres.size() + input.kInPart - 1) / input.kInPart;
    std::vector<PairCounts> counts(parts, PairCounts(pairs.range, width));
    forEachPart(input.threads, centres.size(), input.kInPart,
                [&](std::size_t first, std::size_t end, std::size_t part)
                {
                    for (std::size_t k = first; k < end; ++k)
                    {
                        counts[part].leaveOutItself();
                        input.forEachImage(input.centres[centres[k]], pairs.range,
                                           [&](const Eigen::Vector3d& q, const Eigen::Vector3d&)
                                           { counts[part].look(input.levels, q); });
                    }
                });
    PairCounts sum(pairs.range, width);
    for (const PairCounts& part : counts)
    {
        sum.add(part);
    }
    fillBins(pairs, sum.counts(), width);
    return pairs;
}

} // namespace frostfill

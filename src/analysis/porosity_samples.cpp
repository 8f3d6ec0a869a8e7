// SPDX-License-Identifier: MIT
#include "analysis/porosity_samples.hpp"

#include <algorithm>
#include <array>

namespace frostfill
{
namespace
{

/// Times that the box is filled. Larger: the error is known better and is larger. Smaller: the
/// other way round.
constexpr std::size_t kTimes = 16;
/// Bins of a mean diameter of the profile from the wall: layers there are about one apart.
constexpr double kWallBins = 10;
constexpr std::size_t kPlacesInPart = 4096;

/// Places within the bed, and those of them within a sphere.
struct Counts
{
    std::uint64_t object = 0;
    std::uint64_t spheres = 0;
};

/// What is counted in one go: the bins of all profiles one after another.
class Bins
{
public:
    Bins(const AnalysisInput& input, const ProfileFrame& frame)
        : frame_(frame), bins_(input.settings.bins),
          range_(input.settings.range * input.meanDiameter), largestRadius_(input.largestRadius),
          wallBins_(static_cast<std::size_t>(std::ceil(input.settings.range * kWallBins)))
    {
    }

    // First those of heights, then those about the axis, those from the wall, one that does not
    // matter, the bulk, and all.
    [[nodiscard]] std::size_t size() const { return all() + 1; }
    [[nodiscard]] std::size_t elsewhere() const { return 2 * bins_ + wallBins_; }
    [[nodiscard]] std::size_t bulk() const { return elsewhere() + 1; }
    [[nodiscard]] std::size_t all() const { return bulk() + 1; }
    [[nodiscard]] double bulkBeyond() const { return kBulkBeyond * largestRadius_; }
    /// Up to which the distance from the wall matters.
    [[nodiscard]] double limit() const { return std::max(range_, bulkBeyond()); }
    [[nodiscard]] std::array<std::size_t, 5> of(const Eigen::Vector3d& p, double wall,
                                                double depth) const
    {
        return {binOf(frame_.height(p), frame_.tallest(), bins_),
                bins_ + binOf(frame_.radius(p), frame_.widest(), bins_),
                wall < range_ ? 2 * bins_ + binOf(wall, range_, wallBins_) : elsewhere(),
                isInBulk(wall, depth, largestRadius_) ? bulk() : elsewhere(), all()};
    }
    [[nodiscard]] PorosityBin bounds(std::size_t bin) const
    {
        if (bin < bins_)
        {
            return boundsOf(bin, frame_.tallest(), bins_);
        }
        if (bin < 2 * bins_)
        {
            return boundsOf(bin - bins_, frame_.widest(), bins_);
        }
        if (bin < 2 * bins_ + wallBins_)
        {
            return boundsOf(bin - 2 * bins_, range_, wallBins_);
        }
        return {};
    }
    /// The profile to which a bin belongs.
    [[nodiscard]] std::vector<PorosityBin>* profileOf(PorosityProfiles& profiles,
                                                      std::size_t bin) const
    {
        return bin < bins_                   ? &profiles.height
               : bin < 2 * bins_             ? &profiles.radial
               : bin < 2 * bins_ + wallBins_ ? &profiles.wall
                                             : nullptr;
    }

private:
    static std::size_t binOf(double value, double end, std::size_t count)
    {
        const double bin = std::floor(value / end * static_cast<double>(count));
        return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(count - 1)));
    }
    static PorosityBin boundsOf(std::size_t bin, double end, std::size_t count)
    {
        const double width = end / static_cast<double>(count);
        return {width * static_cast<double>(bin), width * static_cast<double>(bin + 1), 0, 0, 0};
    }

    const ProfileFrame& frame_;
    std::size_t bins_;
    double range_;
    double largestRadius_;
    std::size_t wallBins_;
};

using CountsOfTime = std::vector<Counts>; // [bin]

/// Sets the height of the lowest place that is above the bed.
std::vector<CountsOfTime> countPlaces(const AnalysisInput& input, const ProfileFrame& frame,
                                      const Bins& bins, std::size_t places, double& fullBelow)
{
    const std::size_t parts = (places + kPlacesInPart - 1) / kPlacesInPart;
    std::vector<CountsOfTime> counted(kTimes * parts);
    std::vector<double> lowest(counted.size(), std::numeric_limits<double>::infinity());
    const auto countPart = [&](std::size_t i)
    {
        counted[i].resize(bins.size());
        const std::size_t first = i % parts * kPlacesInPart;
        for (std::size_t k = first; k < std::min(places, first + kPlacesInPart); ++k)
        {
            const Eigen::Vector3d place = placeInBox(frame.box(), i / parts, k);
            if (!input.container.contains(place))
            {
                continue;
            }
            const double depth = input.top.depth(place);
            if (depth < 0)
            {
                lowest[i] = std::min(lowest[i], frame.height(place));
                continue;
            }
            const bool covered = input.levels.covers(place);
            const double wall = input.container.distanceToWall(place, bins.limit());
            for (const std::size_t bin : bins.of(place, wall, depth))
            {
                ++counted[i][bin].object;
                counted[i][bin].spheres += covered ? 1 : 0;
            }
        }
    };
    input.threads.forEachLarge(counted.size(), countPart);
    fullBelow = *std::min_element(lowest.begin(), lowest.end());
    std::vector<CountsOfTime> times(kTimes, CountsOfTime(bins.size()));
    for (std::size_t i = 0; i < counted.size(); ++i)
    {
        for (std::size_t bin = 0; bin < bins.size(); ++bin)
        {
            times[i / parts][bin].object += counted[i][bin].object;
            times[i / parts][bin].spheres += counted[i][bin].spheres;
        }
    }
    return times;
}

double shareFree(const Counts& counts)
{
    return 1 - static_cast<double>(counts.spheres) / static_cast<double>(counts.object);
}

/// False for a bin without a place.
bool fillIn(PorosityBin& row, const std::vector<CountsOfTime>& times, std::size_t bin,
            double volumeOfPlace)
{
    Counts all;
    double sum = 0;
    double squares = 0;
    double count = 0;
    for (const CountsOfTime& time : times)
    {
        all.object += time[bin].object;
        all.spheres += time[bin].spheres;
        if (time[bin].object > 0)
        {
            sum += shareFree(time[bin]);
            squares += shareFree(time[bin]) * shareFree(time[bin]);
            ++count;
        }
    }
    if (all.object == 0)
    {
        return false;
    }
    row.porosity = shareFree(all);
    row.objectVolume = volumeOfPlace * static_cast<double>(all.object);
    const double variance = std::max(0.0, squares - sum * sum / count) / (count - 1);
    row.error = count > 1 ? std::sqrt(variance / count) : AnalysisInput::kNothing;
    return true;
}

} // namespace

SampledPorosity samplePorosity(const AnalysisInput& input, const ProfileFrame& frame)
{
    const Bins bins(input, frame);
    const std::size_t places = (input.settings.samples + kTimes - 1) / kTimes;
    SampledPorosity sampled;
    const std::vector<CountsOfTime> times =
        countPlaces(input, frame, bins, places, sampled.fullBelow);
    const double volumeOfPlace = frame.box().volume() / static_cast<double>(kTimes * places);
    PorosityProfiles& profiles = sampled.profiles;
    for (std::size_t bin = 0; bin < bins.size(); ++bin)
    {
        PorosityBin row = bins.bounds(bin);
        const bool found = fillIn(row, times, bin, volumeOfPlace);
        if (std::vector<PorosityBin>* profile = bins.profileOf(profiles, bin); profile && found)
        {
            profile->push_back(row);
        }
        else if (found && bin == bins.all())
        {
            profiles.whole = row;
        }
        else if (found && bin == bins.bulk())
        {
            row.from = bins.bulkBeyond();
            row.to = AnalysisInput::kNothing;
            profiles.bulk = row;
        }
    }
    return sampled;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "bulk/bulk.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

/// Places in the box of the bulk. Larger: time. Smaller: noise, some 0.001 at a quarter of them.
constexpr std::size_t kPlacesOfBulk = 60000;
/// Fewer places tell too little.
constexpr std::size_t kFewestPlaces = 500;

constexpr std::uint64_t kSeed = 0x706f726f73697479; // any

/// Of the digits of numbers along each axis [Halton 1960]. Multiples of the plastic number of three
/// dimensions fill boxes worse than places at random here, because some of them nearly repeat.
constexpr std::array<std::size_t, 3> kBases = {2, 3, 5};

/// The digits of a number behind the point, in reverse.
double mirrored(std::size_t number, std::size_t base)
{
    std::size_t digits = 0;
    double scale = 1;
    for (; number > 0; number /= base)
    {
        digits = digits * base + number % base;
        scale /= static_cast<double>(base);
    }
    return static_cast<double>(digits) * scale;
}

} // namespace

Eigen::Vector3d placeInBox(const Eigen::AlignedBox3d& box, std::uint64_t time, std::size_t number)
{
    Eigen::Vector3d place;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
        const double at = uniformRandom(kSeed, time, axis) + mirrored(number, kBases[axis]);
        const auto index = static_cast<Eigen::Index>(axis);
        place[index] = box.min()[index] + (at - std::floor(at)) * box.sizes()[index];
    }
    return place;
}

Bulk::Bulk(const Surface& surface, const InsideTest& inside, Eigen::Index up, double largestRadius,
           Threads& threads)
    : up_(up), largestRadius_(largestRadius)
{
    const double beyond = kBulkBeyond * largestRadius;
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(beyond);
    const Eigen::AlignedBox3d box(surface.box().min() + margin, surface.box().max() - margin);
    if (box.isEmpty())
    {
        return;
    }
    std::vector<Eigen::Vector3d> all;
    for (std::size_t k = 0; k < kPlacesOfBulk; ++k)
    {
        all.push_back(placeInBox(box, 0, k));
    }
    std::vector<char> isFar(all.size());
    threads.forEach(all.size(),
                    [&](std::size_t k)
                    {
                        const auto wall =
                            nearestPoint(surface.mesh(), surface.tree(), all[k], beyond);
                        isFar[k] = wall ? 0 : 1;
                    });
    std::vector<Eigen::Vector3d> places;
    for (std::size_t k = 0; k < all.size(); ++k)
    {
        if (isFar[k] != 0 && inside.contains(all[k]))
        {
            places.push_back(all[k]);
        }
    }
    if (!places.empty())
    {
        places_.emplace(places, std::vector<double>(places.size(), largestRadius));
    }
}

std::optional<double> Bulk::fraction(std::span<const Eigen::Vector3d> centres,
                                     std::span<const double> radii) const
{
    if (centres.empty() || !any())
    {
        return std::nullopt;
    }
    const SphereLevels::Level& places = places_->levels().front();
    std::vector<char> isFilled(places.spheres.size(), 0);
    for (std::size_t k = 0; k < centres.size(); ++k)
    {
        const auto fill = [&](std::uint32_t first, std::uint32_t end)
        {
            for (std::uint32_t i = first; i < end; ++i)
            {
                const Eigen::Vector3d away = places.spheres[i].centre - centres[k];
                if (away.squaredNorm() <= radii[k] * radii[k])
                {
                    isFilled[i] = 1;
                }
            }
        };
        places.forEachRange(centres[k], radii[k], fill);
    }
    const BedTop top(up_, centres, radii);
    const double far = std::numeric_limits<double>::infinity(); // from walls
    std::size_t count = 0;
    std::size_t filled = 0;
    for (std::size_t i = 0; i < isFilled.size(); ++i)
    {
        if (isInBulk(far, top.depth(places.spheres[i].centre), largestRadius_))
        {
            ++count;
            filled += isFilled[i] != 0 ? 1 : 0;
        }
    }
    return count < kFewestPlaces
               ? std::nullopt
               : std::optional(static_cast<double>(filled) / static_cast<double>(count));
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "bulk/bulk.hpp"

#include "base/random.hpp"
#include "geometry/sphere_levels.hpp"

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
                        const WallPoint wall = nearestWall(surface, all[k], beyond, beyond);
                        isFar[k] = wall.square > beyond * beyond ? 1 : 0;
                    });
    for (std::size_t k = 0; k < all.size(); ++k)
    {
        if (isFar[k] != 0 && inside.contains(all[k]))
        {
            places_.push_back(all[k]);
        }
    }
}

std::optional<double> Bulk::fraction(std::span<const Eigen::Vector3d> centres,
                                     std::span<const double> radii, Threads& threads) const
{
    if (centres.empty())
    {
        return std::nullopt;
    }
    const BedTop top(up_, centres, radii);
    const SphereLevels levels(centres, radii);
    const double far = std::numeric_limits<double>::infinity(); // from walls
    std::vector<Eigen::Vector3d> inBulk;
    std::copy_if(places_.begin(), places_.end(), std::back_inserter(inBulk),
                 [&](const Eigen::Vector3d& place)
                 { return isInBulk(far, top.depth(place), largestRadius_); });
    if (inBulk.size() < kFewestPlaces)
    {
        return std::nullopt;
    }
    std::vector<char> isFilled(inBulk.size());
    threads.forEach(inBulk.size(),
                    [&](std::size_t k) { isFilled[k] = levels.covers(inBulk[k]) ? 1 : 0; });
    return static_cast<double>(std::count(isFilled.begin(), isFilled.end(), 1)) /
           static_cast<double>(inBulk.size());
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/quality/heap_slope.hpp"

#include "base/statistics.hpp"
#include "simulation/quality/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace frostfill
{
namespace
{

/// Highest points by sector.
struct Ring
{
    static constexpr double kNone = -std::numeric_limits<double>::infinity();
    std::array<double, kSectorsOfHeap> tops;

    Ring() { tops.fill(kNone); }
    /// Of the sectors with a sphere, if these are half of them or more.
    [[nodiscard]] std::optional<double> height() const
    {
        double sum = 0;
        std::size_t sectors = 0;
        for (const double top : tops)
        {
            sum += top > kNone ? top : 0;
            sectors += top > kNone ? 1 : 0;
        }
        if (2 * sectors < tops.size())
        {
            return std::nullopt;
        }
        return sum / static_cast<double>(sectors);
    }
};

double footOf(std::span<const HeapGrain> grains)
{
    std::vector<double> across;
    for (const HeapGrain& grain : grains)
    {
        across.push_back(grain.across);
    }
    return percentile(across, kInHeap);
}

std::size_t sectorOf(double azimuth)
{
    const double share = azimuth / (2 * std::numbers::pi) + 0.5;
    return std::min(
        kSectorsOfHeap - 1,
        static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(kSectorsOfHeap)));
}

/// Down the line of least squares.
std::optional<double> slopeThrough(std::span<const Eigen::Vector2d> points)
{
    if (points.size() < kFewestRings)
    {
        return std::nullopt;
    }
    Eigen::Vector2d mean(0, 0);
    for (const Eigen::Vector2d& point : points)
    {
        mean += point / static_cast<double>(points.size());
    }
    double squares = 0;
    double products = 0;
    for (const Eigen::Vector2d& point : points)
    {
        const Eigen::Vector2d apart = point - mean;
        squares += apart.x() * apart.x();
        products += apart.x() * apart.y();
    }
    return std::atan2(-products, squares);
}

} // namespace

std::optional<double> heapSlope(std::span<const HeapGrain> grains, double radius)
{
    if (grains.empty())
    {
        return std::nullopt;
    }
    const double foot = footOf(grains);
    const double width = 2 * radius;
    std::vector<Ring> rings(static_cast<std::size_t>(kFarthestRing * foot / width) + 1);
    for (const HeapGrain& grain : grains)
    {
        const auto ring = static_cast<std::size_t>(grain.across / width);
        if (ring < rings.size())
        {
            double& top = rings[ring].tops[sectorOf(grain.azimuth)];
            top = std::max(top, grain.top);
        }
    }
    std::vector<Eigen::Vector2d> points;
    for (std::size_t k = 0; k < rings.size(); ++k)
    {
        const double middle = (static_cast<double>(k) + 0.5) * width;
        const auto height = rings[k].height();
        if (height && middle >= kNearestRing * foot && middle <= kFarthestRing * foot)
        {
            points.emplace_back(middle, *height);
        }
    }
    return slopeThrough(points);
}

std::vector<HeapReport> heapsOf(const World& world)
{
    std::vector<Eigen::Vector3d> middles;
    for (const Inlet& inlet : world.scene.spheres.inlets)
    {
        middles.push_back(world.frame.toRun(inlet.centre));
    }
    std::vector<std::vector<HeapGrain>> grains(middles.size());
    for (std::uint32_t id = 0; !middles.empty() && id < world.spheres.size(); ++id)
    {
        if (world.spheres.isRunning(id))
        {
            continue;
        }
        const Eigen::Vector3d p = world.spheres.position(id);
        const auto across = [&](const Eigen::Vector3d& middle)
        { return std::hypot(p.x() - middle.x(), p.z() - middle.z()); };
        const auto nearest =
            std::min_element(middles.begin(), middles.end(),
                             [&](const auto& a, const auto& b) { return across(a) < across(b); });
        grains[static_cast<std::size_t>(nearest - middles.begin())].push_back(
            {across(*nearest), std::atan2(p.z() - nearest->z(), p.x() - nearest->x()),
             p.y() + world.spheres.radius(id)});
    }
    std::vector<HeapReport> heaps;
    for (const std::vector<HeapGrain>& its : grains)
    {
        HeapReport heap{its.size(), {}};
        if (const auto slope = heapSlope(its, 1))
        {
            heap.slope = *slope * 180 / std::numbers::pi;
        }
        heaps.push_back(heap);
    }
    return heaps;
}

} // namespace frostfill

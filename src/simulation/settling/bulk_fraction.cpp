// SPDX-License-Identifier: MIT
#include "simulation/settling/bulk_fraction.hpp"

#include "simulation/settling/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// Places of a cubic lattice in the box, some kPlacesOfBulk, by ascending height.
std::vector<Eigen::Vector3d> latticeIn(const Eigen::AlignedBox3d& box)
{
    const double spacing = std::cbrt(box.volume() / kPlacesOfBulk);
    const Eigen::Array3d sizes = box.sizes().array();
    const Eigen::Array3i counts = (sizes / spacing).ceil().cast<int>();
    const Eigen::Vector3d step = sizes / counts.cast<double>();
    std::vector<Eigen::Vector3d> places;
    for (int y = 0; y < counts.y(); ++y)
    {
        for (int z = 0; z < counts.z(); ++z)
        {
            for (int x = 0; x < counts.x(); ++x)
            {
                const Eigen::Vector3d inCells(x + 0.5, y + 0.5, z + 0.5);
                places.emplace_back(box.min() + step.cwiseProduct(inCells));
            }
        }
    }
    return places;
}

} // namespace

BulkFraction::BulkFraction(const World& world, Threads& threads)
    : world_(world), threads_(threads), grid_(world.spheres.resting().frame())
{
    const Eigen::AlignedBox3d whole = world.surface.box();
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kBulkBeyond);
    const Eigen::AlignedBox3d box(whole.min() + margin, whole.max() - margin);
    if (box.isEmpty())
    {
        return;
    }
    const std::vector<Eigen::Vector3d> all = latticeIn(box);
    std::vector<char> isFar(all.size());
    threads.forEach(all.size(),
                    [&](std::size_t k)
                    {
                        const WallPoint wall =
                            nearestWall(world.surface, all[k], kBulkBeyond, kBulkBeyond);
                        isFar[k] = wall.square > kBulkBeyond * kBulkBeyond ? 1 : 0;
                    });
    for (std::size_t k = 0; k < all.size(); ++k)
    {
        if (isFar[k] != 0 && world.inside.contains(all[k]))
        {
            places_.push_back(all[k]);
        }
    }
}

std::optional<double> BulkFraction::measure()
{
    const RunningSpheres& running = world_.spheres.running();
    if (running.size() == 0)
    {
        return std::nullopt;
    }
    grid_.rebuild(running);
    const double top = topOfPile() - kBulkBeyond;
    const auto end =
        std::partition_point(places_.begin(), places_.end(),
                             [&](const Eigen::Vector3d& place) { return place.y() < top; });
    const auto count = static_cast<std::size_t>(end - places_.begin());
    std::vector<char> isFilled(count);
    threads_.forEach(count,
                     [&](std::size_t k)
                     {
                         grid_.forEachNear(
                             places_[k], 1,
                             [&](std::uint32_t, const Eigen::Vector3d& p, double radius)
                             {
                                 if ((p - places_[k]).squaredNorm() < radius * radius)
                                 {
                                     isFilled[k] = 1;
                                 }
                             });
                     });
    if (count < kFewestPlaces)
    {
        return std::nullopt;
    }
    return static_cast<double>(std::count(isFilled.begin(), isFilled.end(), 1)) /
           static_cast<double>(count);
}

// Of nearly all: a few may lie on a ledge.
double BulkFraction::topOfPile() const
{
    std::vector<double> heights;
    const RunningSpheres& running = world_.spheres.running();
    for (std::uint32_t row = 0; row < running.size(); ++row)
    {
        heights.push_back(running.position[row].y());
    }
    const auto nth = heights.begin() +
                     static_cast<std::ptrdiff_t>(kBelowTop * static_cast<double>(heights.size()));
    std::nth_element(heights.begin(), nth, heights.end());
    return *nth;
}

} // namespace frostfill

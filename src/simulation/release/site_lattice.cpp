// SPDX-License-Identifier: MIT
#include "simulation/release/site_lattice.hpp"

#include "geometry/grid_frame.hpp"
#include "mesh/interior/near_surface.hpp"
#include "simulation/release/tolerances.hpp"
#include "simulation/world/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

/// Of what may be inside of a box with more sites than can be numbered [r^3]; else 0.
double volumeInReach(const Eigen::AlignedBox3d& box, const InsideTest& inside, double cell)
{
    double volume = 0;
    if ((box.sizes().array() / cell + 1).prod() > kMaxSites)
    {
        inside.forEachBoxInReach([&](const Eigen::AlignedBox3d& part)
                                 { volume += part.intersection(box).sizes().cwiseMax(0).prod(); });
    }
    return volume;
}

/// Numbers of sites fit 32 bits; where there are too many, cells grow.
Cubes cubesOf(const Eigen::AlignedBox3d& box, const InsideTest& inside, double radius,
              std::size_t whole)
{
    double cell = cellOfSites(box.sizes(), volumeInReach(box, inside, kSiteCell * radius), radius);
    while (true)
    {
        if (auto cubes =
                Cubes::inReach(GridFrame::cover(box, cell, 0), inside, kMaxSites / 64, whole))
        {
            return *std::move(cubes);
        }
        cell *= kCubeGrowth;
    }
}

} // namespace

double cellOfSites(const Eigen::Vector3d& box, double inReach, double radius)
{
    return std::max({kSiteCell * radius, std::cbrt(inReach / kMaxSites) * (1 + kDistanceRounding),
                     box.maxCoeff() / (kMostCellsAlong - 1)});
}

SiteLattice::SiteLattice(const Surface& surface, const InsideTest& inside, double radius,
                         Threads& threads, double coarsest, std::size_t whole)
    : radius_(radius), cubes_(cubesOf(surface.box(), inside, std::max(radius, coarsest), whole))
{
    // Two sites side by side, none of them near the surface, are on the same side of it.
    const double least = cell() / 2 * (1 + kDistanceRounding);
    depth_ = radius_ - halfDiagonal();
    depth_ = std::abs(depth_) < least ? -least : depth_;
    const CubeSet far = cubesFartherThan(surface, cubes_, std::abs(depth_), cubes_.all(), threads);
    open_ = cubesInside(cubes_, inside, far);
    for (std::size_t word = 0; depth_ < 0 && word < open_.size(); ++word)
    {
        open_[word] |= cubes_.inGrid(word) & ~far[word];
    }
}

void SiteLattice::close(const Eigen::Vector3d& centre, double radius)
{
    const double limit = closedWithin(radius);
    if (limit > 0)
    {
        findRowOfBall(lattice(), centre, limit, kMiddleInBall,
                      [&](int y, int z, CellRun run)
                      {
                          cubes_.takeOut(open_, y, z, run);
                          return false;
                      });
    }
}

std::vector<std::uint32_t> SiteLattice::highest() const
{
    std::vector<std::uint32_t> found;
    for (std::size_t word = 0; word < open_.size(); ++word)
    {
        if (open_[word] == 0)
        {
            continue;
        }
        const auto [x, y, z] = cubes_.first(word);
        const std::uint64_t above = open_[cubes_.wordIfAny(x / 64, y + 1, z)];
        for (std::uint64_t bits = open_[word] & ~above; bits != 0; bits &= bits - 1)
        {
            const auto bit = static_cast<std::size_t>(std::countr_zero(bits));
            found.push_back(static_cast<std::uint32_t>(64 * word + bit));
        }
    }
    return found;
}

std::size_t SiteLattice::nextOpen(std::size_t site) const
{
    std::size_t word = site / 64;
    if (word >= open_.size())
    {
        return end();
    }
    std::uint64_t rest = open_[word] & (~std::uint64_t{0} << (site % 64));
    while (rest == 0)
    {
        if (++word == open_.size())
        {
            return end();
        }
        rest = open_[word];
    }
    return word * 64 + static_cast<std::size_t>(std::countr_zero(rest));
}

} // namespace frostfill

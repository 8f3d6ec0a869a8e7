// SPDX-License-Identifier: MIT
#include <simulation/release_search.hpp>

#include <simulation/clear_place.hpp>
#include <simulation/random.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kRadius = 1; // all lengths are in radii
constexpr double kCell = 0.5; // edge of a lattice cell
constexpr double kHalfDiagonal = 0.8660254037844387 * kCell;
constexpr double kFarthest = 2 * kHalfDiagonal; // a place may be from its lattice point
constexpr double kTopBand = 2; // sites whose heights differ by less come in random order
constexpr int kMoves = 24;     // attempts at moving a place out of an overlap

std::array<int, 3> cellOf(const GridFrame& lattice, std::uint32_t site)
{
    const auto nx = static_cast<std::uint32_t>(lattice.count[0]);
    const auto ny = static_cast<std::uint32_t>(lattice.count[1]);
    return {static_cast<int>(site % nx), static_cast<int>(site / nx % ny),
            static_cast<int>(site / nx / ny)};
}

Eigen::Vector3d centreOf(const GridFrame& lattice, std::uint32_t site)
{
    const auto c = cellOf(lattice, site);
    return lattice.centre(c[0], c[1], c[2]);
}

} // namespace

ReleaseSearch::ReleaseSearch(const World& world)
    : world_(world), lattice_(GridFrame::cover(world.surface.box(), kCell, 0))
{
    // A cell is of use when one of its points may be a radius away from the wall.
    for (std::uint32_t site = 0; site < lattice_.size(); ++site)
    {
        if (world.inside.distance(centreOf(lattice_, site)) >= kRadius - kHalfDiagonal)
        {
            sites_.push_back(site);
        }
    }

    std::vector<std::pair<double, std::uint32_t>> order;
    order.reserve(sites_.size());
    for (const std::uint32_t site : sites_)
    {
        const double height = centreOf(lattice_, site).y();
        order.emplace_back(-height + kTopBand * uniformRandom(world.scene.seed, site, 0), site);
    }
    std::sort(order.begin(), order.end());
    std::transform(order.begin(), order.end(), sites_.begin(),
                   [](const auto& entry) { return entry.second; });
}

std::vector<Eigen::Vector3d> ReleaseSearch::find(std::size_t count)
{
    std::vector<Eigen::Vector3d> released;
    std::size_t kept = 0;
    std::size_t next = 0;
    for (; next < sites_.size() && released.size() < count; ++next)
    {
        const std::uint32_t site = sites_[next];
        const Eigen::Vector3d centre = centreOf(lattice_, site);
        Eigen::Vector3d p = centre;
        if (takenForGood(centre))
        {
            continue;
        }
        for (int axis = 0; axis < 3; ++axis)
        {
            p[axis] += kCell * (uniformRandom(world_.scene.seed, site, ++draws_) - 0.5);
        }
        // The spheres at rest only grow in number: what they leave no room for now stays so.
        if (!moveClear(world_, p, kRadius, kFarthest))
        {
            p = centre;
            if (!moveClear(world_, p, kRadius, kFarthest))
            {
                continue;
            }
        }
        sites_[kept++] = site;
        if (clearOfRunning(p, released))
        {
            released.push_back(p);
        }
    }
    sites_.erase(sites_.begin() + static_cast<std::ptrdiff_t>(kept),
                 sites_.begin() + static_cast<std::ptrdiff_t>(next));
    return released;
}

bool ReleaseSearch::takenForGood(const Eigen::Vector3d& site) const
{
    const double limit = 2 * kRadius - kHalfDiagonal;
    bool taken = false;
    world_.resting.forEachNear(site, limit,
                               [&](std::uint32_t id)
                               {
                                   const Eigen::Vector3d d = world_.spheres.position(id) - site;
                                   taken = taken || d.squaredNorm() < limit * limit;
                               });
    return taken;
}

bool ReleaseSearch::clearOfRunning(const Eigen::Vector3d& p,
                                   const std::vector<Eigen::Vector3d>& released) const
{
    const double contact = 2 * kRadius + kClearance;
    const auto clear = [&](const Eigen::Vector3d& other)
    { return (other - p).squaredNorm() >= contact * contact; };
    for (std::size_t id = world_.restingCount; id < world_.spheres.size(); ++id)
    {
        if (!clear(world_.spheres.position(id)))
        {
            return false;
        }
    }
    return std::all_of(released.begin(), released.end(), clear);
}

} // namespace frostfill

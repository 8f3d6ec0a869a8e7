// SPDX-License-Identifier: MIT
#include "bed/links.hpp"

#include <frostfill/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

/// [radius] from the centre, below which nothing is flattened: spheres that overlap so far are
/// broken.
constexpr double kDeepestCut = 0.3;
/// [rad] between two directions to a wall that are the same.
constexpr double kSameDirection = 1e-3;
constexpr std::size_t kInPart = 256;

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

[[noreturn]] void refuseSphere(std::size_t k, const Eigen::Vector3d& centre, const char* what)
{
    throw Error(ErrorCode::badData, fmt::format("sphere {} at ({:.6g}, {:.6g}, {:.6g}) {}", k,
                                                centre.x(), centre.y(), centre.z(), what));
}

void findWalls(const Bed& bed, std::uint32_t k, std::vector<BedLink>& links)
{
    const Eigen::Vector3d& centre = bed.centre(k);
    const double radius = bed.treatedRadius(k);
    const double reach = radius * (1 + bed.settings().gap);
    const SignedDistance wall =
        nearestDistance(bed.surface(), centre, bed.mesh().vertices.empty() ? 0 : 1e300);
    if (wall.value <= 0)
    {
        refuseSphere(k, centre, "has its centre outside the container");
    }
    if (bed.settings().contacts == ContactTreatment::shrink && wall.value <= radius)
    {
        refuseSphere(k, centre,
                     "passes through the wall even when shrunk; shrink more, or use caps");
    }
    if (bed.settings().contacts != ContactTreatment::caps || wall.value >= reach)
    {
        return;
    }
    std::vector<std::uint32_t> near;
    bed.surface().tree().findNear(centre, reach, near);
    std::sort(near.begin(), near.end());
    std::vector<BedLink> found;
    for (const std::uint32_t triangle : near)
    {
        const auto& corner = bed.surface()[triangle].corner;
        const Eigen::Vector3d point =
            closestPointOnTriangle(centre, corner[0], corner[1], corner[2]).point;
        const double away = (point - centre).norm();
        if (away < reach)
        {
            found.push_back(
                {.first = k, .gap = away - radius, .direction = (point - centre) / away});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const BedLink& a, const BedLink& b) { return a.gap < b.gap; });
    const std::size_t before = links.size();
    for (const BedLink& link : found)
    {
        const auto isSame = [&](const BedLink& other)
        { return angleBetween(link.direction, other.direction) < kSameDirection; };
        if (std::none_of(links.begin() + static_cast<std::ptrdiff_t>(before), links.end(), isSame))
        {
            links.push_back(link);
        }
    }
}

void findPairs(const Bed& bed, std::uint32_t k, std::vector<BedLink>& links)
{
    const Eigen::Vector3d& centre = bed.centre(k);
    const double radius = bed.treatedRadius(k);
    const bool treated = bed.settings().contacts == ContactTreatment::caps;
    const auto look = [&](std::uint32_t id, const Eigen::Vector3d& other, double)
    {
        if (id <= k)
        {
            return;
        }
        const double theirs = bed.treatedRadius(id);
        const double away = (other - centre).norm();
        const double gap = away - radius - theirs;
        if (bed.settings().contacts == ContactTreatment::shrink && gap <= 0)
        {
            refuseSphere(k, centre,
                         fmt::format("overlaps sphere {} by {:.3g} even when shrunk; shrink more, "
                                     "or use caps",
                                     id, -gap)
                             .c_str());
        }
        if (treated && gap < bed.settings().gap * std::min(radius, theirs))
        {
            if (away < 1e-9 * radius)
            {
                refuseSphere(k, centre, fmt::format("has the centre of sphere {}", id).c_str());
            }
            links.push_back(
                {.first = k, .second = id, .gap = gap, .direction = (other - centre) / away});
        }
    };
    const std::size_t before = links.size();
    bed.levels().forEachNear(
        centre, [&](double largest) { return (radius + largest) * (1 + bed.settings().gap); },
        look);
    std::sort(links.begin() + static_cast<std::ptrdiff_t>(before), links.end(),
              [](const BedLink& a, const BedLink& b) { return a.second < b.second; });
}

} // namespace

double cutOf(const Bed& bed, const BedLink& link, std::uint32_t sphere)
{
    const double radius = bed.radius(sphere);
    if (link.second == BedLink::kWall)
    {
        return 1 + link.gap / radius - bed.settings().gap;
    }
    const double smaller = std::min(bed.radius(link.first), bed.radius(link.second));
    return 1 - (bed.settings().gap * smaller - link.gap) / 2 / radius;
}

BedLinks findLinks(const Bed& bed)
{
    const std::size_t parts = (bed.size() + kInPart - 1) / kInPart;
    std::vector<std::vector<BedLink>> found(parts);
    forEachPart(bed.threads(), bed.size(), kInPart,
                [&](std::size_t first, std::size_t end, std::size_t part)
                {
                    for (std::size_t k = first; k < end; ++k)
                    {
                        findPairs(bed, static_cast<std::uint32_t>(k), found[part]);
                        findWalls(bed, static_cast<std::uint32_t>(k), found[part]);
                    }
                });
    BedLinks all;
    all.ofSphere.resize(bed.size());
    for (const std::vector<BedLink>& part : found)
    {
        for (const BedLink& link : part)
        {
            const auto number = static_cast<std::uint32_t>(all.links.size());
            all.links.push_back(link);
            all.ofSphere[link.first].push_back(number);
            double cut = cutOf(bed, link, link.first);
            if (link.second != BedLink::kWall)
            {
                all.ofSphere[link.second].push_back(number);
                cut = std::min(cut, cutOf(bed, link, link.second));
            }
            if (cut < kDeepestCut)
            {
                refuseSphere(link.first, bed.centre(link.first),
                             "reaches so far into what is beside it that nothing is left of it");
            }
        }
    }
    return all;
}

} // namespace frostfill

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

/// Share of the distance from a contact to what else is near that a bridge may be thick. Two that
/// have no sphere in common are apart if it is below 1/2, and what it leaves is for the mesher.
constexpr double kRoom = 0.4;
/// Share of the angle between two links of a sphere that each bridge may have.
constexpr double kAngleRoom = 0.45;
/// Share of the angle between two links that both may take.
constexpr double kBeside = 0.95;
/// Share of the radius that was asked for, below which there is no bridge.
constexpr double kThinnest = 0.25;
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

bool isTreated(ContactTreatment contacts)
{
    return contacts == ContactTreatment::caps || contacts == ContactTreatment::bridges;
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
                     "passes through the wall even when shrunk; shrink more, or use "
                     "caps or bridges");
    }
    if (!isTreated(bed.settings().contacts) || wall.value >= reach)
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
    const bool treated = isTreated(bed.settings().contacts);
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
                                     "or use caps or bridges",
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

/// The thickest bridge that others leave room for; 0 for none, as to a wall.
double bridgeOf(const Bed& bed, const BedLinks& all, const BedLink& link)
{
    if (link.second == BedLink::kWall)
    {
        return 0;
    }
    const double first = bed.radius(link.first);
    const double smaller = std::min(first, bed.radius(link.second));
    const double asked = bed.settings().bridge * smaller;
    const Eigen::Vector3d place = bed.centre(link.first) + (first + link.gap / 2) * link.direction;
    double room = asked / kRoom;
    bed.levels().forEachNear(
        place, [&](double largest) { return largest + room; },
        [&](std::uint32_t id, const Eigen::Vector3d& centre, double radius)
        {
            if (id != link.first && id != link.second)
            {
                room = std::min(room, (centre - place).norm() - radius);
            }
        });
    room = std::min(room, std::sqrt(nearestWall(bed.surface(), place, room, 0).square));
    double bridge = std::min(asked, kRoom * room);
    for (const std::uint32_t sphere : {link.first, link.second})
    {
        const Eigen::Vector3d own =
            sphere == link.first ? link.direction : Eigen::Vector3d(-link.direction);
        for (const std::uint32_t other : all.ofSphere[sphere])
        {
            if (&all.links[other] == &link)
            {
                continue;
            }
            const double angle = angleBetween(own, all.direction(other, sphere));
            bridge = std::min(bridge, bed.radius(sphere) * std::sin(kAngleRoom * angle));
        }
    }
    // Where two overlap, the circle in which they meet lies well within.
    const double circle = link.gap < 0 ? std::sqrt(-2 * link.gap * smaller) : 0;
    return bridge >= kThinnest * asked && bridge > 2 * circle ? bridge : 0;
}

/// Whether a bridge of a sphere and another link leave each other room.
bool leaveRoom(const Bed& bed, const BedLinks& all, std::uint32_t sphere, std::uint32_t bridge,
               std::uint32_t other)
{
    const BedLink& its = all.links[other];
    const double angle = angleBetween(all.direction(bridge, sphere), all.direction(other, sphere));
    const double wide = std::asin(all.links[bridge].bridge / bed.radius(sphere));
    const double theirs = its.bridge > 0 ? std::asin(its.bridge / bed.radius(sphere))
                                         : std::acos(std::min(1.0, cutOf(bed, its, sphere)));
    return wide + theirs < kBeside * angle;
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

namespace
{

/// Turns bridges that others leave no room for into flattened places, until all have room.
void dropWhatDoesNotFit(const Bed& bed, BedLinks& all)
{
    for (bool changed = true; changed;)
    {
        changed = false;
        for (std::uint32_t sphere = 0; sphere < bed.size(); ++sphere)
        {
            for (const std::uint32_t link : all.ofSphere[sphere])
            {
                for (const std::uint32_t other : all.ofSphere[sphere])
                {
                    if (other != link && all.links[link].bridge > 0 &&
                        !leaveRoom(bed, all, sphere, link, other))
                    {
                        all.links[link].bridge = 0;
                        changed = true;
                    }
                }
            }
        }
    }
    for (const BedLink& link : all.links)
    {
        const double smaller = link.second == BedLink::kWall
                                   ? bed.radius(link.first)
                                   : std::min(bed.radius(link.first), bed.radius(link.second));
        ++(link.bridge > 0 ? all.bridged : all.flattened);
        all.thinned +=
            link.bridge > 0 && link.bridge < bed.settings().bridge * smaller * (1 - 1e-9) ? 1 : 0;
    }
}

} // namespace

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
    if (bed.settings().contacts == ContactTreatment::bridges)
    {
        std::vector<double> bridges(all.links.size());
        forEachPart(bed.threads(), all.links.size(), kInPart,
                    [&](std::size_t first, std::size_t end, std::size_t)
                    {
                        for (std::size_t k = first; k < end; ++k)
                        {
                            bridges[k] = bridgeOf(bed, all, all.links[k]);
                        }
                    });
        for (std::size_t k = 0; k < bridges.size(); ++k)
        {
            all.links[k].bridge = bridges[k];
        }
    }
    dropWhatDoesNotFit(bed, all);
    return all;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "bed/hole_cutter.hpp"

#include "bed/sphere_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace frostfill
{
namespace
{

/// Cosine of the angle to the axis up to which a wall may be part of a hole. Larger: fewer bridges
/// where walls bend. Smaller: longer triangles.
constexpr double kFacing = 0.4;
/// [radius of the bridge] that points keep from one another. Larger: fewer bridges. Smaller:
/// triangles so thin that rounding to single precision turns them over.
constexpr double kApart = 0.015;
/// [height of the cap that a bridge takes from its sphere] that walls stay away. Likewise.
constexpr double kAway = 0.1;
/// Edges that one side of a bridge may cross, and pieces on the way to a corner.
constexpr int kMostCrossings = 64;
constexpr int kMostSteps = 100'000;
/// Cosine of the angle by which rounding may turn a piece.
constexpr double kTurned = 0.99;

double turnOf(const Eigen::Vector2d& u, const Eigen::Vector2d& v)
{
    return u.x() * v.y() - u.y() * v.x();
}

double distanceToSide(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    const Eigen::Vector2d along = b - a;
    const double share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p - a - share * along).norm();
}

} // namespace

HoleCutter::HoleCutter(const Bed& bed, WallMesh& walls, const BedLink& link)
    : bed_(bed), walls_(walls), link_(link), centre_(bed.centre(link.first)),
      right_(link.direction.unitOrthogonal()), forward_(link.direction.cross(right_))
{
    const double radius = bed.radius(link.first);
    start_ = std::sqrt(radius * radius - link.bridge * link.bridge);
    margin_ = kAway * (radius - start_);
    near_ = kApart * link.bridge;
}

bool HoleCutter::faces(std::uint32_t piece) const
{
    return walls_.normal(piece).dot(link_.direction) > kFacing;
}

/// The piece that a line along the axis meets, seen from one that is near; kNone where the way
/// ends.
std::uint32_t HoleCutter::find(const Plane& p, std::uint32_t from) const
{
    std::uint32_t piece = from;
    for (int step = 0; step < kMostSteps && piece != WallMesh::kNone && faces(piece); ++step)
    {
        const WallMesh::Piece& its = walls_[piece];
        std::size_t edge = 0;
        for (; edge < 3; ++edge)
        {
            const Plane a = across(its.corner[edge]);
            if (turnOf(across(its.corner[(edge + 1) % 3]) - a, p - a) < 0)
            {
                break;
            }
        }
        if (edge == 3)
        {
            return piece;
        }
        piece = its.beyond[edge];
    }
    return WallMesh::kNone;
}

bool HoleCutter::isBelowSphere(std::uint32_t v) const
{
    return height(walls_.vertex(v)) > start_ + margin_;
}

std::optional<std::uint32_t> HoleCutter::addCorner(const Plane& p, std::uint32_t from)
{
    const std::uint32_t piece = find(p, from);
    if (piece == WallMesh::kNone || walls_[piece].isHole)
    {
        return {};
    }
    const WallMesh::Piece& its = walls_[piece];
    std::size_t on = 3; // an edge of a plane on which the corner is
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
        const Plane a = across(its.corner[edge]);
        if ((p - a).norm() < near_)
        {
            return {};
        }
        if (distanceToSide(p, a, across(its.corner[(edge + 1) % 3])) < near_)
        {
            if (!walls_.isFree(piece, edge) || walls_[its.beyond[edge]].isHole)
            {
                return {};
            }
            on = edge;
        }
    }
    const Eigen::Vector3d normal = walls_.normal(piece);
    const Eigen::Vector3d beside = centre_ + p.x() * right_ + p.y() * forward_;
    const Eigen::Vector3d place = beside + normal.dot(walls_.vertex(its.corner[0]) - beside) /
                                               normal.dot(link_.direction) * link_.direction;
    const std::uint32_t v =
        on < 3 ? walls_.addOn(piece, on, place) : walls_.addWithin(piece, place);
    walls_.improveAround(v);
    return isBelowSphere(v) ? std::optional(v) : std::nullopt;
}

/// Where the way from one vertex to another crosses an edge there is a new vertex.
std::optional<std::uint32_t> HoleCutter::cross(std::uint32_t from, std::uint32_t to)
{
    const Plane begin = across(from);
    const Plane way = across(to) - begin;
    for (const std::uint32_t piece : walls_.around(from))
    {
        const WallMesh::Piece& its = walls_[piece];
        const std::size_t edge = (WallMesh::placeOf(its, from) + 1) % 3;
        const Plane a = across(its.corner[edge]);
        const Plane b = across(its.corner[(edge + 1) % 3]);
        if (!faces(piece) || turnOf(a - begin, way) <= 0 || turnOf(way, b - begin) <= 0)
        {
            continue;
        }
        const double along = turnOf(a - begin, way) / turnOf(way, b - a);
        const Plane meets = a + along * (b - a);
        const std::uint32_t other = its.beyond[edge];
        if (its.isFixed[edge] || its.isHole || other == WallMesh::kNone || walls_[other].isHole ||
            std::min({(meets - a).norm(), (meets - b).norm(), (meets - begin).norm(),
                      (meets - across(to)).norm()}) < near_)
        {
            return {};
        }
        const Eigen::Vector3d low = walls_.vertex(its.corner[edge]);
        const Eigen::Vector3d high = walls_.vertex(its.corner[(edge + 1) % 3]);
        const std::uint32_t v = walls_.addOn(piece, edge, low + along * (high - low));
        return isBelowSphere(v) ? std::optional(v) : std::nullopt;
    }
    return {};
}

bool HoleCutter::drawEdge(std::uint32_t from, std::uint32_t to, std::vector<std::uint32_t>& edge)
{
    edge.assign(1, from);
    const auto isDrawn = [&](std::uint32_t end)
    {
        for (const std::uint32_t piece : walls_.around(edge.back()))
        {
            const std::size_t place = WallMesh::placeOf(walls_[piece], edge.back());
            if (walls_[piece].corner[(place + 1) % 3] == end)
            {
                walls_.fix(piece, place);
                return true;
            }
        }
        return false;
    };
    for (int crossing = 0; crossing < kMostCrossings; ++crossing)
    {
        if (isDrawn(to))
        {
            return true;
        }
        const std::optional<std::uint32_t> next = cross(edge.back(), to);
        if (!next || !isDrawn(*next))
        {
            return false;
        }
        edge.push_back(*next);
    }
    return false;
}

/// The side of a bridge is a fan about its corner on the sphere.
bool HoleCutter::isSeenFromSphere(const std::vector<std::uint32_t>& edge, std::uint32_t last) const
{
    const Plane begin = across(edge.front());
    const auto place = [&](std::size_t k)
    {
        const std::uint32_t v = k < edge.size() ? edge[k] : last;
        return Plane((across(v) - begin).norm(), height(walls_.vertex(v)) - start_);
    };
    for (std::size_t k = 0; k < edge.size(); ++k)
    {
        if (turnOf(place(k), place(k + 1)) >= 0)
        {
            return false;
        }
    }
    return true;
}

/// Marks what lies to the left of an edge, up to edges that are kept.
bool HoleCutter::openHole(std::uint32_t first, std::uint32_t second)
{
    std::vector<std::uint32_t> waiting;
    for (const std::uint32_t piece : walls_.around(first))
    {
        const std::size_t place = WallMesh::placeOf(walls_[piece], first);
        if (walls_[piece].corner[(place + 1) % 3] == second)
        {
            waiting.push_back(piece);
        }
    }
    bool isWithin = !waiting.empty();
    while (!waiting.empty() && isWithin)
    {
        const std::uint32_t piece = waiting.back();
        waiting.pop_back();
        if (walls_[piece].isHole)
        {
            continue;
        }
        const WallMesh::Piece its = walls_[piece];
        walls_.makeHole(piece);
        isWithin = faces(piece);
        for (std::size_t edge = 0; edge < 3; ++edge)
        {
            isWithin = isWithin && across(its.corner[edge]).norm() < link_.bridge + near_ &&
                       its.beyond[edge] != WallMesh::kNone;
            if (!its.isFixed[edge] && its.beyond[edge] != WallMesh::kNone)
            {
                waiting.push_back(its.beyond[edge]);
            }
        }
    }
    return isWithin;
}

/// Whether rounding has turned none of the pieces that are new.
bool HoleCutter::isSound() const
{
    const std::vector<std::uint32_t> changed = walls_.changed();
    return std::all_of(changed.begin(), changed.end(),
                       [&](std::uint32_t piece)
                       {
                           const auto& corner = walls_[piece].corner;
                           const Eigen::Vector3d& a = walls_.vertex(corner[0]);
                           const Eigen::Vector3d normal =
                               (walls_.vertex(corner[1]) - a).cross(walls_.vertex(corner[2]) - a);
                           return normal.dot(walls_.normal(piece)) > kTurned * normal.norm();
                       });
}

/// Whether no other wall comes between the sphere and the hole.
bool HoleCutter::isClear() const
{
    std::vector<std::uint32_t> planes;
    for (const std::uint32_t piece : walls_.changed())
    {
        planes.push_back(walls_[piece].plane);
    }
    const double foot = bed_.radius(link_.first) + link_.gap;
    std::vector<std::uint32_t> near;
    bed_.surface().tree().findNear(centre_ + foot * link_.direction, link_.bridge, near);
    return std::all_of(
        near.begin(), near.end(),
        [&](std::uint32_t t)
        {
            if (std::find(planes.begin(), planes.end(), t) != planes.end())
            {
                return true;
            }
            const auto& corner = bed_.surface()[t].corner;
            const Eigen::Vector3d nearest = closestPointOnTriangle(centre_ + foot * link_.direction,
                                                                   corner[0], corner[1], corner[2])
                                                .point;
            return across(nearest).norm() > 0.9 * link_.bridge || height(nearest) > foot - margin_;
        });
}

bool HoleCutter::tryToCut(std::vector<std::vector<std::uint32_t>>& edges)
{
    const std::uint32_t corners = cornersOf(bed_, link_);
    const double radius = bed_.radius(link_.first);
    std::vector<std::uint32_t> ring;
    for (std::uint32_t k = 0; k < corners; ++k)
    {
        const Plane p = across(centre_ + radius * cornerOf(bed_, link_, link_.first, k, corners));
        const std::optional<std::uint32_t> v = addCorner(p, link_.triangle);
        if (!v)
        {
            return false;
        }
        ring.push_back(*v);
    }
    edges.resize(corners);
    for (std::uint32_t k = 0; k < corners; ++k)
    {
        const std::uint32_t next = ring[(k + 1) % corners];
        if (!drawEdge(ring[k], next, edges[k]) || !isSeenFromSphere(edges[k], next))
        {
            return false;
        }
    }
    const std::uint32_t second = edges[0].size() > 1 ? edges[0][1] : ring[1];
    if (!openHole(ring[0], second) || !isSound() || !isClear())
    {
        return false;
    }
    for (const std::uint32_t v : ring)
    {
        walls_.improveAround(v);
    }
    return isSound();
}

std::vector<std::vector<std::uint32_t>> HoleCutter::cut()
{
    std::vector<std::vector<std::uint32_t>> edges;
    walls_.begin();
    if (!tryToCut(edges))
    {
        walls_.takeBack();
        edges.clear();
    }
    return edges;
}

} // namespace frostfill

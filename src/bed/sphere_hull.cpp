// SPDX-License-Identifier: MIT
#include "bed/sphere_hull.hpp"

#include "geometry/exact_predicates.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <stdexcept>
#include <utility>

namespace frostfill
{

bool SphereHull::sees(std::uint32_t point, std::uint32_t piece) const
{
    const Face& corner = pieces_[piece].corner;
    return orient3d(points_[corner[0]], points_[corner[1]], points_[corner[2]], points_[point]) > 0;
}

/// Four points that are far from a plane, each the farthest from those before.
void SphereHull::begin()
{
    const auto farthest = [&](auto&& distance)
    {
        std::uint32_t best = 0;
        for (std::uint32_t k = 1; k < points_.size(); ++k)
        {
            best = distance(points_[k]) > distance(points_[best]) ? k : best;
        }
        return best;
    };
    const Eigen::Vector3d& a = points_[0];
    const std::uint32_t second = farthest([&](const Eigen::Vector3d& p) { return (p - a).norm(); });
    const Eigen::Vector3d& b = points_[second];
    const std::uint32_t third =
        farthest([&](const Eigen::Vector3d& p) { return (p - a).cross(b - a).norm(); });
    const Eigen::Vector3d normal = (b - a).cross(points_[third] - a);
    const std::uint32_t fourth =
        farthest([&](const Eigen::Vector3d& p) { return std::abs((p - a).dot(normal)); });
    first_ = {0, second, third, fourth};
    const int side = orient3d(a, b, points_[third], points_[fourth]);
    if (side == 0)
    {
        throw std::logic_error("the points of a sphere lie in a plane");
    }
    if (side > 0) // the first face would see the fourth point
    {
        std::swap(first_[1], first_[2]);
    }
    const auto& [p, q, r, s] = first_;
    pieces_ = {{{p, q, r}, {1, 2, 3}},
               {{q, p, s}, {0, 3, 2}},
               {{r, q, s}, {0, 1, 3}},
               {{p, r, s}, {0, 2, 1}}};
}

/// A piece that the point sees, near those that were made last.
std::uint32_t SphereHull::visibleFrom(std::uint32_t point)
{
    queue_.assign(1, static_cast<std::uint32_t>(pieces_.size() - 1));
    const std::uint32_t mark = 2 * point + 1;
    pieces_[queue_.front()].seenBy = mark;
    for (std::size_t k = 0; k < queue_.size(); ++k)
    {
        if (sees(point, queue_[k]))
        {
            return queue_[k];
        }
        for (const std::uint32_t next : pieces_[queue_[k]].beyond)
        {
            if (pieces_[next].seenBy != mark)
            {
                pieces_[next].seenBy = mark;
                queue_.push_back(next);
            }
        }
    }
    throw std::logic_error("a point of a sphere lies within the others");
}

void SphereHull::add(std::uint32_t point)
{
    const std::uint32_t mark = 2 * point + 2;
    seen_.assign(1, visibleFrom(point));
    pieces_[seen_.front()].seenBy = mark;
    const auto firstNew = static_cast<std::uint32_t>(pieces_.size());
    for (std::size_t k = 0; k < seen_.size(); ++k)
    {
        for (std::size_t edge = 0; edge < 3; ++edge)
        {
            const std::uint32_t next = pieces_[seen_[k]].beyond[edge];
            if (pieces_[next].seenBy == mark)
            {
                continue;
            }
            if (sees(point, next))
            {
                pieces_[next].seenBy = mark;
                seen_.push_back(next);
            }
        }
    }
    for (const std::uint32_t piece : seen_)
    {
        pieces_[piece].isGone = true;
    }
    for (const std::uint32_t piece : seen_)
    {
        for (std::size_t edge = 0; edge < 3; ++edge)
        {
            const std::uint32_t next = pieces_[piece].beyond[edge];
            if (pieces_[next].isGone)
            {
                continue;
            }
            const std::uint32_t from = pieces_[piece].corner[edge];
            const std::uint32_t to = pieces_[piece].corner[(edge + 1) % 3];
            const auto made = static_cast<std::uint32_t>(pieces_.size());
            pieces_.push_back({{from, to, point}, {next, 0, 0}});
            startsAt_[from] = made;
            for (std::size_t k = 0; k < 3; ++k)
            {
                if (pieces_[next].corner[k] == to && pieces_[next].corner[(k + 1) % 3] == from)
                {
                    pieces_[next].beyond[k] = made;
                }
            }
        }
    }
    for (std::uint32_t made = firstNew; made < pieces_.size(); ++made)
    {
        const std::uint32_t after = startsAt_[pieces_[made].corner[1]];
        pieces_[made].beyond[1] = after;
        pieces_[after].beyond[2] = made;
    }
}

void SphereHull::build(std::span<const Eigen::Vector3d> points)
{
    points_ = points;
    startsAt_.assign(points.size(), 0);
    begin();
    for (std::uint32_t k = 0; k < points.size(); ++k)
    {
        if (k != first_[0] && k != first_[1] && k != first_[2] && k != first_[3])
        {
            add(k);
        }
    }
    faces_.clear();
    for (const Piece& piece : pieces_)
    {
        if (!piece.isGone)
        {
            faces_.push_back(piece.corner);
        }
    }
}

} // namespace frostfill

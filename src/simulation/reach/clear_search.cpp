// SPDX-License-Identifier: MIT
#include "simulation/reach/clear_search.hpp"

#include "simulation/reach/cube_parts.hpp"
#include "simulation/reach/tolerances.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace frostfill
{

bool ClearSearch::mayBeClear(const Eigen::Vector3d& middle, double edge) const
{
    thread_local Nearby nearby; // keeps its memory
    if (halvings_ > CubeParts::kTimes)
    {
        const double reach = kHalfDiagonal * edge;
        gatherBalls(middle, reach, nearby);
        gatherWalls(middle, probe_ + reach, nearby);
        return anyClear(middle, edge, halvings_, nearby.all(), nearby);
    }
    gatherBalls(middle, CubeParts::kReach * edge, nearby);
    nearby.away.setZero();
    CubeParts parts(middle, edge);
    takeInBalls(middle, edge, nearby.all(), nearby, parts);
    if (!parts.any())
    {
        return false;
    }
    const double ofPart = edge / CubeParts::kSide;
    gatherWalls(middle, exclusionOfPart(ofPart) + CubeParts::kFarthestMiddle * edge, nearby);
    nearby.away += nearby.awayFromWalls;
    return anyUnwalled(parts, ofPart, nearby.all(), nearby);
}

void ClearSearch::gatherBalls(const Eigen::Vector3d& middle, double reach, Nearby& nearby) const
{
    nearby.balls.clear();
    resting_.forEachNear(middle, 1 + probe_ + reach,
                         [&](std::uint32_t row)
                         {
                             const Ball& s = resting_[row];
                             const double radius = s.radius + probe_ - overlap_ - kReachRounding;
                             const Eigen::Vector3d centre = s.position();
                             if (row != ignored_ && (centre - middle).squaredNorm() <
                                                        (radius + reach) * (radius + reach))
                             {
                                 nearby.balls.push_back({centre, radius * radius, radius});
                             }
                         });
}

void ClearSearch::gatherWalls(const Eigen::Vector3d& middle, double distance, Nearby& nearby) const
{
    nearby.walls.clear();
    nearby.places.fill(Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()));
    nearby.next = 0;
    nearby.awayFromWalls.setZero();
    const std::span<const std::uint32_t> triangles = triangles_.near(middle);
    nearby.many = triangles.size() > TriangleGrid::kShortList;
    for (const std::uint32_t id : nearby.many ? std::span<const std::uint32_t>{} : triangles)
    {
        const TriangleBound& bound = surface_.bound(id);
        // Most are out by the ball around them.
        if (bound.ballIsWithin(distance, bound.toCentreSquared(middle)) &&
            bound.mayBeWithin(distance, middle))
        {
            nearby.walls.push_back(id);
            nearby.awayFromWalls += bound.normal;
        }
    }
}

// Cubes that lie in one exclusion as a whole have no part that does not: so it is enough to look at
// parts of parts, down to the smallest.
bool ClearSearch::anyClear(const Eigen::Vector3d& middle, double edge, int halvings,
                           const Obstacles& from, Nearby& nearby) const
{
    CubeParts parts(middle, edge);
    const double ofPart = edge / CubeParts::kSide;
    const double exclusion = exclusionOfPart(ofPart);
    nearby.away = nearby.awayFromWalls;
    takeInBalls(middle, edge, from, nearby, parts);
    for (std::size_t k = 0; k < std::min(nearby.next, nearby.places.size()) && parts.any(); ++k)
    {
        parts.takeMiddleInBall(nearby.places[k], exclusion * exclusion);
    }
    if (halvings <= CubeParts::kTimes)
    {
        return anyUnwalled(parts, ofPart, from, nearby);
    }
    const Obstacles here = select(middle, kHalfDiagonal * edge, from, nearby);
    const auto mayBeClear = [&](const Eigen::Vector3d& p)
    {
        return !isWalled(p, exclusion, here, nearby) &&
               anyClear(p, ofPart, halvings - CubeParts::kTimes, here, nearby);
    };
    const bool found = parts.anyClear(nearby.away, mayBeClear);
    nearby.balls.resize(here.firstBall);
    nearby.walls.resize(here.firstWall);
    return found;
}

// An eighth that lies in the exclusion of a wall has no part that does not. Most cubes that have a
// clear part at all show it first.
bool ClearSearch::anyUnwalled(CubeParts& parts, double edge, const Obstacles& from,
                              Nearby& nearby) const
{
    const double exclusion = exclusionOfPart(edge);
    bool isFirst = true;
    const auto isClear = [&](const Eigen::Vector3d& p)
    {
        if (!isWalled(p, exclusion, from, nearby))
        {
            return true;
        }
        if (std::exchange(isFirst, false))
        {
            parts.takeEighths(
                [&](const Eigen::Vector3d& middle)
                { return isWalled(middle, exclusionOfPart(2 * edge), from, nearby); });
        }
        return false;
    };
    return parts.anyClear(nearby.away, isClear);
}

void ClearSearch::takeInBalls(const Eigen::Vector3d& middle, double edge, const Obstacles& from,
                              Nearby& nearby, CubeParts& parts)
{
    const double reach = CubeParts::kReach * edge;
    for (std::size_t k = from.firstBall; k < from.endOfBalls && parts.any(); ++k)
    {
        const Exclusion& ball = nearby.balls[k];
        const Eigen::Vector3d way = middle - ball.centre;
        if (way.squaredNorm() < (ball.radius + reach) * (ball.radius + reach))
        {
            parts.takeInBall(ball.centre, ball.square);
            nearby.away += way;
        }
    }
}

// Those that come within `reach` of the middle of a part go to the end of the lists.
ClearSearch::Obstacles ClearSearch::select(const Eigen::Vector3d& middle, double reach,
                                           const Obstacles& from, Nearby& nearby) const
{
    Obstacles here{nearby.balls.size(), 0, nearby.walls.size(), 0};
    for (std::size_t k = from.firstBall; k < from.endOfBalls; ++k)
    {
        const Exclusion ball = nearby.balls[k];
        if ((middle - ball.centre).squaredNorm() < (ball.radius + reach) * (ball.radius + reach))
        {
            nearby.balls.push_back(ball);
        }
    }
    for (std::size_t k = from.firstWall; k < from.endOfWalls; ++k)
    {
        const std::uint32_t id = nearby.walls[k];
        if (surface_.bound(id).mayBeWithin(probe_ + reach, middle))
        {
            nearby.walls.push_back(id);
        }
    }
    here.endOfBalls = nearby.balls.size();
    here.endOfWalls = nearby.walls.size();
    return here;
}

// Parts beside one another are mostly excluded by the same place of a wall.
bool ClearSearch::isWalled(const Eigen::Vector3d& part, double distance, const Obstacles& among,
                           Nearby& nearby) const
{
    if (among.firstWall == among.endOfWalls && !nearby.many)
    {
        return false;
    }
    const double square = distance * distance;
    const auto isNear = [&](const Eigen::Vector3d& p) { return (part - p).squaredNorm() < square; };
    if (std::any_of(nearby.places.begin(), nearby.places.end(), isNear))
    {
        return true;
    }
    const auto remember = [&](const Eigen::Vector3d& p)
    { nearby.places[nearby.next++ % nearby.places.size()] = p; };
    if (nearby.many)
    {
        const WallPoint nearest = nearestWall(surface_, part, distance, distance);
        if (nearest.square < square)
        {
            remember(nearest.point);
        }
        return nearest.square < square;
    }
    const std::span<std::uint32_t> walls = nearby.wallsOf(among);
    for (std::uint32_t& id : walls)
    {
        if (!surface_.bound(id).mayBeWithin(distance, part))
        {
            continue;
        }
        const auto& [a, b, c] = surface_[id].corner;
        Eigen::Vector3d place = surface_.bound(id).centre; // one of its points
        if (!isNear(place))
        {
            place = closestPointOnTriangle(part, a, b, c).point;
        }
        if (isNear(place))
        {
            remember(place);
            std::swap(id, walls.front()); // asked first from now on
            return true;
        }
    }
    return false;
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/reach/clear_search.hpp"

#include "simulation/reach/cube_parts.hpp"
#include "simulation/reach/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

// Of the parts of a cube that is halved twice, each is looked at by itself: what lies in one
// exclusion as a whole has no part that does not.
bool ClearSearch::mayBeClear(const Eigen::Vector3d& middle, double edge) const
{
    thread_local Nearby nearby; // keeps its memory
    CubeParts parts(middle, edge);
    Eigen::Vector3d escape = gatherBalls(middle, CubeParts::kReach * edge, nearby);
    for (const Exclusion& ball : nearby.balls)
    {
        parts.takeInBall(ball.centre, ball.square);
    }
    if (!parts.any())
    {
        return false;
    }
    escape += gatherWalls(middle, CubeParts::kReach * edge, nearby);
    nearby.points.clear();
    const double whole = exclusionOfPart(edge / 4);
    if (!parts.anyClear(escape,
                        [&](const Eigen::Vector3d& p) { return !walled(p, whole, nearby); }))
    {
        return false;
    }
    if (halvings_ <= CubeParts::kTimes)
    {
        return true;
    }
    gatherBalls(middle, kHalfDiagonal * edge, nearby);
    gatherWalls(middle, kHalfDiagonal * edge, nearby);
    return search(middle, edge, halvings_, {0, nearby.balls.size()}, nearby);
}

// The way out of all that is gathered, roughly.
Eigen::Vector3d ClearSearch::gatherWalls(const Eigen::Vector3d& middle, double reach,
                                         Nearby& nearby) const
{
    Eigen::Vector3d escape = Eigen::Vector3d::Zero();
    nearby.walls.clear();
    const std::span<const std::uint32_t> triangles = triangles_.near(middle);
    nearby.many = triangles.size() > TriangleGrid::kShortList;
    const double distance = probe_ + reach;
    for (const std::uint32_t id : nearby.many ? std::span<const std::uint32_t>{} : triangles)
    {
        const TriangleBound& bound = surface_.bound(id);
        // Most are out by the ball around them.
        if (bound.ballIsWithin(distance, bound.toCentreSquared(middle)) &&
            bound.mayBeWithin(distance, middle))
        {
            nearby.walls.push_back(id);
            escape += bound.normal;
        }
    }
    return escape;
}

Eigen::Vector3d ClearSearch::gatherBalls(const Eigen::Vector3d& middle, double reach,
                                         Nearby& nearby) const
{
    Eigen::Vector3d escape = Eigen::Vector3d::Zero();
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
                                 escape += middle - centre;
                             }
                         });
    return escape;
}

double ClearSearch::exclusionOfPart(double edge) const
{
    return std::max(0.0, probe_ - overlap_ - kReachRounding - kHalfDiagonal * edge);
}

// Parts beside one another are mostly excluded by the same place of a wall.
bool ClearSearch::walled(const Eigen::Vector3d& part, double distance, Nearby& nearby) const
{
    const double square = distance * distance;
    const auto isNear = [&](const Eigen::Vector3d& p) { return (part - p).squaredNorm() < square; };
    if (std::any_of(nearby.points.begin(), nearby.points.end(), isNear))
    {
        return true;
    }
    if (nearby.many)
    {
        const WallPoint nearest = nearestWall(surface_, part, distance, distance);
        if (nearest.square < square)
        {
            nearby.points.push_back(nearest.point);
        }
        return nearest.square < square;
    }
    for (const std::uint32_t id : nearby.walls)
    {
        if (!surface_.bound(id).mayBeWithin(distance, part))
        {
            continue;
        }
        const auto& [a, b, c] = surface_[id].corner;
        Eigen::Vector3d point = surface_.bound(id).centre; // one of its points
        if (!isNear(point))
        {
            point = closestPointOnTriangle(part, a, b, c).point;
        }
        if (isNear(point))
        {
            nearby.points.push_back(point);
            return true;
        }
    }
    return false;
}

bool ClearSearch::search(const Eigen::Vector3d& middle, double edge, int halvings,
                         const Obstacles& from, Nearby& nearby) const
{
    Obstacles here{nearby.balls.size(), 0};
    Middle state;
    bool found = false;
    if (!select(middle, edge / 2, from, nearby, state) && !walled(middle, edge, nearby, state))
    {
        here.end = nearby.balls.size();
        found = halvings == 0 || state.clear;
        // The part first that lies the way out, the opposite one last.
        const int first = (state.escape.x() < 0 ? 1 : 0) | (state.escape.y() < 0 ? 2 : 0) |
                          (state.escape.z() < 0 ? 4 : 0);
        for (int k = 0; k < 8 && !found; ++k)
        {
            const int part = first ^ k;
            const Eigen::Vector3d shift(0.5 - (part & 1), 0.5 - (part >> 1 & 1),
                                        0.5 - (part >> 2 & 1));
            found = search(middle + edge / 2 * shift, edge / 2, halvings - 1, here, nearby);
        }
    }
    nearby.balls.resize(here.begin);
    return found;
}

bool ClearSearch::select(const Eigen::Vector3d& middle, double half, const Obstacles& from,
                         Nearby& nearby, Middle& state)
{
    const double reach = 2 * kHalfDiagonal * half;
    for (std::size_t k = from.begin; k < from.end; ++k)
    {
        const Exclusion ball = nearby.balls[k];
        const Eigen::Array3d apart = (ball.centre - middle).array().abs();
        if ((apart + half).square().sum() < ball.square)
        {
            return true;
        }
        const double square = apart.square().sum();
        if (square < ball.square)
        {
            state.clear = false;
            state.escape += middle - ball.centre;
        }
        if (square < (ball.radius + reach) * (ball.radius + reach))
        {
            nearby.balls.push_back(ball);
        }
    }
    return false;
}

bool ClearSearch::walled(const Eigen::Vector3d& middle, double edge, const Nearby& nearby,
                         Middle& state) const
{
    const double exclusion = probe_ - overlap_ - kReachRounding;
    const double whole = exclusionOfPart(edge);
    if (nearby.many)
    {
        const double limit = state.clear ? exclusion : whole;
        const WallPoint nearest = nearestWall(surface_, middle, limit, whole);
        if (nearest.square < exclusion * exclusion)
        {
            state.clear = false;
            state.escape += middle - nearest.point;
        }
        return nearest.square < whole * whole;
    }
    for (const std::uint32_t id : nearby.walls)
    {
        if (!surface_.bound(id).mayBeWithin(state.clear ? exclusion : whole, middle))
        {
            continue;
        }
        const auto& [a, b, c] = surface_[id].corner;
        const Eigen::Vector3d apart = middle - closestPointOnTriangle(middle, a, b, c).point;
        const double square = apart.squaredNorm();
        if (square < whole * whole)
        {
            return true;
        }
        if (square < exclusion * exclusion)
        {
            state.clear = false;
            state.escape += apart;
        }
    }
    return false;
}

} // namespace frostfill

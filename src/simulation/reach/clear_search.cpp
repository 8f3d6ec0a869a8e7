// SPDX-License-Identifier: MIT
#include "simulation/reach/clear_search.hpp"

#include "simulation/reach/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace frostfill
{

bool ClearSearch::mayBeClear(const Eigen::Vector3d& middle, double edge) const
{
    thread_local Nearby nearby; // keeps its memory
    gather(middle, edge, nearby);
    return search(middle, edge, halvings_, {0, nearby.balls.size()}, nearby);
}

void ClearSearch::gather(const Eigen::Vector3d& middle, double edge, Nearby& nearby) const
{
    nearby.walls.clear();
    const std::span<const std::uint32_t> triangles = triangles_.near(middle);
    nearby.many = triangles.size() > TriangleGrid::kShortList;
    const double distance = probe_ + kHalfDiagonal * edge;
    for (const std::uint32_t id : nearby.many ? std::span<const std::uint32_t>{} : triangles)
    {
        if (surface_.bound(id).mayBeWithin(distance, middle))
        {
            nearby.walls.push_back(id);
        }
    }
    nearby.balls.clear();
    const double reach = kHalfDiagonal * edge;
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
    const double whole = std::max(0.0, exclusion - kHalfDiagonal * edge);
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

// SPDX-License-Identifier: MIT
#include <simulation/clear_search.hpp>

#include <algorithm>
#include <cmath>

namespace frostfill
{
namespace
{

constexpr double kRounding = 1e-9; // [r], above the rounding of any coordinate, on the safe side

} // namespace

void ClearSearch::gather(const Eigen::Vector3d& middle, double edge)
{
    walls_.clear();
    for (const std::uint32_t id : triangles_.near(middle))
    {
        if (surface_.bound(id).mayBeWithin(probe_ + kHalfDiagonal * edge, middle))
        {
            walls_.push_back(id);
        }
    }
    balls_.clear();
    const double reach = kHalfDiagonal * edge;
    resting_.forEachNear(middle, 1 + probe_ + reach,
                         [&](std::uint32_t id)
                         {
                             const GridSphere& s = resting_[id];
                             const double radius = s.radius + probe_ - overlap_ - kRounding;
                             const Eigen::Vector3d centre = s.position();
                             if (id != ignored_ && (centre - middle).squaredNorm() <
                                                       (radius + reach) * (radius + reach))
                             {
                                 balls_.push_back({centre, radius * radius, radius});
                             }
                         });
}

bool ClearSearch::search(const Eigen::Vector3d& middle, double edge, int halvings,
                         const Obstacles& from)
{
    bool clear = true;
    Obstacles here{balls_.size(), 0};
    bool found = false;
    if (!select(middle, edge / 2, from, clear) && !walled(middle, edge, clear))
    {
        here.end = balls_.size();
        found = halvings == 0 || clear;
        for (int part = 0; part < 8 && !found; ++part)
        {
            // The upper parts first: what is free is free above.
            const Eigen::Vector3d shift((part & 1) - 0.5, 0.5 - (part >> 2 & 1),
                                        (part >> 1 & 1) - 0.5);
            found = search(middle + edge / 2 * shift, edge / 2, halvings - 1, here);
        }
    }
    balls_.resize(here.begin);
    return found;
}

bool ClearSearch::select(const Eigen::Vector3d& middle, double half, const Obstacles& from,
                         bool& clear)
{
    const double reach = 2 * kHalfDiagonal * half;
    for (std::size_t k = from.begin; k < from.end; ++k)
    {
        const Exclusion ball = balls_[k];
        const Eigen::Array3d apart = (ball.centre - middle).array().abs();
        if ((apart + half).square().sum() < ball.square)
        {
            return true;
        }
        const double square = apart.square().sum();
        clear = clear && square >= ball.square;
        if (square < (ball.radius + reach) * (ball.radius + reach))
        {
            balls_.push_back(ball);
        }
    }
    return false;
}

bool ClearSearch::walled(const Eigen::Vector3d& middle, double edge, bool& clear) const
{
    const double exclusion = probe_ - overlap_ - kRounding;
    const double whole = std::max(0.0, exclusion - kHalfDiagonal * edge);
    for (const std::uint32_t id : walls_)
    {
        // What is farther from the triangle's plane is farther from the triangle.
        const SurfaceTriangle& triangle = surface_[id];
        const double decisive = clear ? exclusion : whole;
        if (std::abs(triangle.normal.dot(middle) - triangle.offset) >= decisive)
        {
            continue;
        }
        const auto& [a, b, c] = triangle.corner;
        const double square =
            (closestPointOnTriangle(middle, a, b, c).point - middle).squaredNorm();
        if (square < whole * whole)
        {
            return true;
        }
        clear = clear && square >= exclusion * exclusion;
    }
    return false;
}

} // namespace frostfill

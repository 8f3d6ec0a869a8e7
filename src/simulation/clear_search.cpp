// SPDX-License-Identifier: MIT
#include <simulation/clear_search.hpp>

#include <algorithm>

namespace frostfill
{
namespace
{

constexpr double kRounding = 1e-9; // [r], above the rounding of any coordinate, on the safe side

} // namespace

void ClearSearch::gather(const Eigen::Vector3d& middle, double edge)
{
    balls_.clear();
    const double reach = kHalfDiagonal * edge;
    resting_.forEachNear(middle, 1 + probe_ + edge / 2,
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

bool ClearSearch::walled(const Eigen::Vector3d& middle, double edge, bool& walls,
                         bool& clear) const
{
    if (!walls)
    {
        return false;
    }
    // The distance from the surface changes no faster than the place.
    const double distance = inside_.distance(middle) - (probe_ - overlap_ - kRounding);
    const double reach = kHalfDiagonal * edge;
    walls = distance < reach;
    clear = clear && distance >= 0;
    return distance < -reach;
}

} // namespace frostfill

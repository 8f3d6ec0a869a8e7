// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/interior/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace frostfill
{

/// By which a distance may be wrong, a thousandfold. [1]
inline constexpr double kDistanceRounding = 1e-9;

/// Whether points are within `reach` of a triangle. Its plane decides of most, and balls around
/// points that it has; the nearest of its points is looked for where those do not.
class NearTriangle
{
public:
    NearTriangle(const Surface& surface, std::uint32_t triangle, double reach)
        : corner_(&surface[triangle].corner), bound_(&surface.bound(triangle)), reach_(reach),
          surelyOut_((1 + kDistanceRounding) * reach),
          surelyIn_(std::max(0.0, (1 - kDistanceRounding) * reach))
    {
    }

    [[nodiscard]] bool contains(const Eigen::Vector3d& p) const
    {
        if (bound_->toCentreSquared(p) <= surelyIn_ * surelyIn_)
        {
            return true;
        }
        const auto& [a, b, c] = *corner_;
        return bound_->mayBeWithin(surelyOut_, p) &&
               (closestPointOnTriangle(p, a, b, c).point - p).squaredNorm() <= reach_ * reach_;
    }

    /// Points of a line along x, from one place to another; none where `to` is less than `from`.
    struct Chord
    {
        double from = std::numeric_limits<double>::infinity();
        double to = -std::numeric_limits<double>::infinity();
    };
    /// All that are within reach of the triangle's plane.
    [[nodiscard]] Chord nearPlane(double y, double z) const
    {
        constexpr double kInfinity = std::numeric_limits<double>::infinity();
        const Eigen::Vector3d& normal = bound_->normal;
        if (std::abs(normal.x()) <= kSteep)
        {
            return {-kInfinity, kInfinity};
        }
        const double middle = (bound_->offset - (normal.y() * y + normal.z() * z)) / normal.x();
        const double half = surelyOut_ / std::abs(normal.x());
        return {middle - half, middle + half};
    }
    /// Some that are surely within reach of the triangle. It is convex, and so is all that is near
    /// it: between two such points, all are.
    [[nodiscard]] Chord surelyNear(double y, double z) const
    {
        Chord chord;
        const auto take = [&](const Eigen::Vector3d& point)
        {
            const double dy = y - point.y();
            const double dz = z - point.z();
            const double square = surelyIn_ * surelyIn_ - (dy * dy + dz * dz);
            if (square >= 0)
            {
                const double half = std::sqrt(square);
                chord.from = std::min(chord.from, point.x() - half);
                chord.to = std::max(chord.to, point.x() + half);
            }
        };
        std::for_each(corner_->begin(), corner_->end(), take);
        return chord;
    }

private:
    /// A plane that a line meets at a smaller sine is not used to shorten it.
    static constexpr double kSteep = 1e-6;

    const std::array<Eigen::Vector3d, 3>* corner_;
    const TriangleBound* bound_;
    double reach_;
    double surelyOut_;
    double surelyIn_;
};

} // namespace frostfill

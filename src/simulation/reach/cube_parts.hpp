// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/grid_frame.hpp"
#include "simulation/reach/tolerances.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace frostfill
{

/// The 64 parts of a cube that is halved twice, and which of them no exclusion takes by itself.
class CubeParts
{
public:
    /// How often the cube is halved.
    static constexpr int kTimes = 2;
    static constexpr int kSide = 1 << kTimes; ///< parts side by side
    /// How much farther from the cube's middle than an exclusion reaches its centre may be, where
    /// it takes a part. [edge]
    static constexpr double kReach = kHalfDiagonal / 2;
    /// How far from the cube's middle those of the parts are, rounded up. [edge]
    static constexpr double kFarthestMiddle = 0.75 * kHalfDiagonal * (1 + 1e-9);

    CubeParts(const Eigen::Vector3d& middle, double edge) : half_(edge / 8)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            for (std::size_t k = 0; k < kSide; ++k)
            {
                // As one halving after the other would.
                const double half = edge / 4 * (k / 2 == 0 ? -1 : 1);
                const double quarter = edge / 8 * (k % 2 == 0 ? -1 : 1);
                along_[axis][k] = middle[static_cast<int>(axis)] + half + quarter;
            }
        }
    }

    /// Whether some are left.
    [[nodiscard]] bool any() const { return left_ != 0; }

    /// Takes those that lie in a ball altogether.
    void takeInBall(const Eigen::Vector3d& centre, double squaredRadius)
    {
        take(centre, squaredRadius, half_);
    }
    /// Takes those whose middle does.
    void takeMiddleInBall(const Eigen::Vector3d& centre, double squaredRadius)
    {
        take(centre, squaredRadius, 0);
    }

    /// Takes all parts of each eighth of the cube for whose middle isTaken(middle) holds.
    template <class IsTaken>
    void takeEighths(IsTaken&& isTaken)
    {
        for (std::size_t eighth = 0; eighth < 8; ++eighth)
        {
            const std::array<std::size_t, 3> at = {eighth % 2, eighth / 2 % 2, eighth / 4};
            const Parts its = kEighth << (2 * (at[0] + kSide * at[1] + kRows * at[2]));
            Eigen::Vector3d middle;
            for (std::size_t axis = 0; axis < 3; ++axis)
            {
                middle[static_cast<int>(axis)] = along_[axis][2 * at[axis]] + half_;
            }
            if ((left_ & its) != 0 && isTaken(middle))
            {
                left_ &= ~its;
            }
        }
    }

    /// Whether isClear(middle) holds for one of them; those that lie far out along `way` first. It
    /// may take others, which are then not asked for.
    template <class IsClear>
    [[nodiscard]] bool anyClear(const Eigen::Vector3d& way, IsClear&& isClear) const
    {
        constexpr int kAlong = kSide - 1;
        const int x = way.x() < 0 ? 0 : kAlong;
        const int y = way.y() < 0 ? 0 : kAlong;
        const int z = way.z() < 0 ? 0 : kAlong;
        const int first = (z << kTimes | y) << kTimes | x;
        for (int k = 0; k <= kLast; ++k)
        {
            const int part = first ^ k;
            if ((left_ >> part & 1) != 0 && isClear(middleOf(part)))
            {
                return true;
            }
        }
        return false;
    }

private:
    using Parts = std::uint64_t;                             ///< a bit for each, x fastest
    using Places = std::array<std::array<double, kSide>, 3>; ///< by axis

    [[nodiscard]] Eigen::Vector3d middleOf(int part) const
    {
        const auto at = static_cast<std::size_t>(part);
        return {along_[0][at % kSide], along_[1][at / kSide % kSide], along_[2][at / kRows]};
    }

    /// Those of which all that is as far as this from the middle along the axes lies in the ball.
    void take(const Eigen::Vector3d& centre, double squaredRadius, double beyond)
    {
        Places farthest; // squares of the distances of their far sides
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            for (std::size_t k = 0; k < kSide; ++k)
            {
                const double apart = centre[static_cast<int>(axis)] - along_[axis][k];
                const double far = std::abs(apart) + beyond;
                farthest[axis][k] = far * far;
            }
        }
        left_ &= ~below(farthest, squaredRadius);
    }

    /// Those of which the sum of what is given along each axis is below a limit.
    [[nodiscard]] static Parts below(const Places& given, double limit)
    {
        using Two = double __attribute__((vector_size(2 * sizeof(double))));
        using TwoParts = Parts __attribute__((vector_size(2 * sizeof(Parts))));
        const Two first = {given[0][0], given[0][1]};
        const Two second = {given[0][2], given[0][3]};
        TwoParts found = {0, 0};
        TwoParts ofFirst = {1, 2};
        TwoParts ofSecond = {4, 8};
        for (std::size_t row = 0; row < kRows; ++row)
        {
            const double rest = given[1][row % kSide] + given[2][row / kSide];
            found |= ((first + rest < limit) & ofFirst) | ((second + rest < limit) & ofSecond);
            ofFirst <<= kSide;
            ofSecond <<= kSide;
        }
        return found[0] | found[1];
    }

    static constexpr int kLast = (1 << 3 * kTimes) - 1;
    static constexpr std::size_t kRows = std::size_t{kSide} * kSide;
    /// Two by two by two parts, from the first on.
    static constexpr Parts kEighth = Parts{0x33} | Parts{0x33} << kRows;
    double half_;  ///< of a part's edge
    Places along_; ///< of their middles
    Parts left_ = ~Parts{0};
};

} // namespace frostfill

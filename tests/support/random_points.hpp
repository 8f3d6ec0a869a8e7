// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace frostfill
{

/// Numbers and points of which each is another, and the same ones for the same seed.
class RandomPoints
{
public:
    explicit RandomPoints(std::uint64_t seed) : seed_(seed) {}
    double uniform(double low, double high)
    {
        return low + (high - low) * uniformRandom(seed_, 0, draws_++);
    }
    Eigen::Vector3d point(double low, double high)
    {
        const double x = uniform(low, high);
        const double y = uniform(low, high);
        return {x, y, uniform(low, high)};
    }
    /// On a sphere of the given radius.
    Eigen::Vector3d direction(double length)
    {
        while (true)
        {
            const Eigen::Vector3d p = point(-1, 1);
            if (p.squaredNorm() <= 1 && p.squaredNorm() > 0.01)
            {
                return p.normalized() * length;
            }
        }
    }

private:
    std::uint64_t seed_;
    std::uint64_t draws_ = 0;
};

} // namespace frostfill

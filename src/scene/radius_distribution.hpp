// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/scene.hpp>

#include <vector>

namespace frostfill
{

/// Which radii spheres get, and how likely each is.
class RadiusDistribution
{
public:
    /// Reads the file, if there is one: a radius a line; empty lines and what follows a # do not
    /// count. Throws Error inputMissing, or badData with the line.
    explicit RadiusDistribution(const Radii& radii);

    [[nodiscard]] double smallest() const { return smallest_; }
    [[nodiscard]] double largest() const { return largest_; }
    [[nodiscard]] bool equal() const { return smallest_ == largest_; }
    /// The mean of r^power.
    [[nodiscard]] double meanPower(int power) const;
    /// Maps a uniform random number in [0, 1) to a radius, among those that are at most `limit`;
    /// never below the smallest.
    [[nodiscard]] double draw(double uniform, double limit) const;
    /// The different radii, ascending, when there are at most `most` of them; otherwise empty.
    [[nodiscard]] std::vector<double> distinct(std::size_t most) const;
    /// The same with another unit of length: the largest is then exactly 1.
    [[nodiscard]] RadiusDistribution inLargest() const;

private:
    double smallest_ = 1;
    double largest_ = 1;
    std::vector<double> values_; ///< ascending; empty when all between the two are equally likely
};

} // namespace frostfill

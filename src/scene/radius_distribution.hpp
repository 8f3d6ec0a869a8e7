// SPDX-License-Identifier: MIT
// Room: the scene, a plain value that describes a run, with what follows from it alone: presets,
// radii, frames. Nothing here runs anything.
#pragma once

#include "scene/size_curve.hpp"

#include <frostfill/scene.hpp>

#include <optional>
#include <vector>

namespace frostfill
{

/// The distribution of the radii.
class RadiusDistribution
{
public:
    /// Reads the file, if any: one radius per line; ignores empty lines and comments after #.
    /// Throws Error inputMissing, or badData with the line.
    explicit RadiusDistribution(const Radii& radii);
    /// A size curve. Throws what readSizeCurve throws.
    explicit RadiusDistribution(const SizeSettings& sizes);

    [[nodiscard]] double smallest() const { return smallest_; }
    [[nodiscard]] double largest() const { return largest_; }
    [[nodiscard]] bool equal() const { return smallest_ == largest_; }
    /// The mean of r^power.
    [[nodiscard]] double meanPower(int power) const;
    /// Maps a uniform random number in [0, 1) to a radius of at most `limit`, but never below the
    /// smallest.
    [[nodiscard]] double draw(double uniform, double limit) const;
    /// The different radii, ascending; empty if there are more than `most`.
    [[nodiscard]] std::vector<double> distinct(std::size_t most) const;
    /// The same distribution in the largest radius as unit: the largest is then exactly 1.
    [[nodiscard]] RadiusDistribution inLargest() const;
    /// That of a size curve, in the unit of this distribution.
    [[nodiscard]] const std::optional<SizeCurve>& curve() const { return curve_; }

private:
    double smallest_ = 1;
    double largest_ = 1;
    std::vector<double> values_;     ///< ascending; empty for a uniform range
    std::optional<SizeCurve> curve_; ///< then the rest is not used but for the ends
};

} // namespace frostfill

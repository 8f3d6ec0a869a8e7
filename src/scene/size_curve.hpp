// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace frostfill
{

/// A distribution of radii, given by shares of the number or of the mass of all spheres. It is made
/// of pieces, in each of which these shares are spread evenly over the radii, so that a cumulative
/// curve is a line from row to row. Everything else follows in closed form: with the density
/// f(r) dr of shares of r^w, w = 0 or 3, that of the number is f(r) r^-w over its integral.
class SizeCurve
{
public:
    struct Piece
    {
        double low;   ///< radius
        double high;  ///< radius; as `low` if all have one size
        double share; ///< [1] of the whole; above 0
    };
    static constexpr int kNumber = 0; ///< powers of r
    static constexpr int kMass = 3;

    /// `pieces` ascend and do not overlap; their shares add up to about 1. `sieves`: the radii at
    /// which the curve is looked at, ascending.
    SizeCurve(std::vector<Piece> pieces, int power, std::vector<double> sieves);

    [[nodiscard]] double smallest() const { return pieces_.front().low; }
    [[nodiscard]] double largest() const { return pieces_.back().high; }
    [[nodiscard]] const std::vector<double>& sieves() const { return sieves_; }
    /// The mean of r^power over all spheres.
    [[nodiscard]] double meanPower(int power) const;
    /// Which share of the number (power 0) or of the mass (3) is of at most this radius.
    [[nodiscard]] double cumulative(double radius, int power) const;
    /// The radius below which this share of the number is, in [0, 1].
    [[nodiscard]] double quantile(double share) const;
    /// The radii, ascending, if there are only some; otherwise empty.
    [[nodiscard]] std::vector<double> distinct() const;
    /// With this as the unit of length.
    [[nodiscard]] SizeCurve in(double unit) const;

private:
    [[nodiscard]] double momentOf(const Piece& piece, int power) const;
    [[nodiscard]] std::vector<double> sumsOf(int power) const;

    std::vector<Piece> pieces_;
    int power_;
    std::vector<double> sieves_;
    // What there is up to the end of each piece, but for a factor.
    std::vector<double> numbers_;
    std::vector<double> masses_;
};

} // namespace frostfill

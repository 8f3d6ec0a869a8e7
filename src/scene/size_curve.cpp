// SPDX-License-Identifier: MIT
#include "scene/size_curve.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frostfill
{
namespace
{

/// The integral of r^power.
double integral(double low, double high, int power)
{
    if (power == -1)
    {
        return std::log(high / low);
    }
    return (std::pow(high, power + 1) - std::pow(low, power + 1)) / (power + 1);
}

/// The mean of r^power over even radii.
double meanOver(double low, double high, int power)
{
    const double width = high - low;
    // Where the difference of two powers would be rounding, the middle is as good.
    constexpr double kNarrow = 1e-7;
    return width <= kNarrow * high ? std::pow(low + width / 2, power)
                                   : integral(low, high, power) / width;
}

} // namespace

SizeCurve::SizeCurve(std::vector<Piece> pieces, int power, std::vector<double> sieves)
    : pieces_(std::move(pieces)), power_(power), sieves_(std::move(sieves)),
      numbers_(sumsOf(kNumber)), masses_(sumsOf(kMass))
{
}

std::vector<double> SizeCurve::sumsOf(int power) const
{
    std::vector<double> sums;
    double sum = 0;
    for (const Piece& piece : pieces_)
    {
        sums.push_back(sum += momentOf(piece, power));
    }
    return sums;
}

// Of the number, but for a factor.
double SizeCurve::momentOf(const Piece& piece, int power) const
{
    return piece.share * meanOver(piece.low, piece.high, power - power_);
}

double SizeCurve::meanPower(int power) const
{
    return sumsOf(power).back() / numbers_.back();
}

double SizeCurve::cumulative(double radius, int power) const
{
    const std::vector<double>& sums = power == kNumber ? numbers_ : masses_;
    const auto above = std::partition_point(pieces_.begin(), pieces_.end(),
                                            [&](const Piece& one) { return one.high <= radius; });
    const auto k = static_cast<std::size_t>(above - pieces_.begin());
    double below = k == 0 ? 0 : sums[k - 1];
    if (above != pieces_.end() && above->low < radius)
    {
        const double part = (radius - above->low) / (above->high - above->low);
        below += momentOf({above->low, radius, above->share * part}, power);
    }
    return below / sums.back();
}

double SizeCurve::quantile(double share) const
{
    const double wanted = share * numbers_.back();
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), wanted);
    const auto k = static_cast<std::size_t>(std::min(found, numbers_.end() - 1) - numbers_.begin());
    const double before = k == 0 ? 0 : numbers_[k - 1];
    const double part = std::clamp((wanted - before) / (numbers_[k] - before), 0.0, 1.0);
    const Piece& piece = pieces_[k];
    double radius = piece.low + part * (piece.high - piece.low);
    if (power_ == kMass && piece.high > piece.low)
    {
        // The number falls with r^-3, and what is above r with r^-2.
        const double low = 1 / (piece.low * piece.low);
        const double high = 1 / (piece.high * piece.high);
        radius = 1 / std::sqrt(low + part * (high - low));
    }
    return std::clamp(radius, piece.low, piece.high);
}

std::vector<double> SizeCurve::distinct() const
{
    std::vector<double> radii;
    for (const Piece& piece : pieces_)
    {
        if (piece.low < piece.high)
        {
            return {};
        }
        radii.push_back(piece.low);
    }
    return radii;
}

SizeCurve SizeCurve::in(double unit) const
{
    std::vector<Piece> pieces = pieces_;
    std::vector<double> sieves = sieves_;
    for (Piece& piece : pieces)
    {
        piece.low /= unit;
        piece.high /= unit;
    }
    for (double& sieve : sieves)
    {
        sieve /= unit;
    }
    return {std::move(pieces), power_, std::move(sieves)};
}

} // namespace frostfill

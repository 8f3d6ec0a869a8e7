// SPDX-License-Identifier: MIT
#include "analysis/bond_order.hpp"

#include <cmath>
#include <cstddef>

namespace frostfill
{
namespace
{

/// What stands before the polynomials of the harmonics, times sqrt(4 pi / 13), without signs, which
/// go out in the squares.
const std::array<double, 7> kFactors = {
    1.0 / 16,
    std::sqrt(42.0) / 16,
    std::sqrt(420.0) / 64,
    std::sqrt(420.0) / 32,
    3 * std::sqrt(14.0) / 32,
    3 * std::sqrt(308.0) / 32,
    std::sqrt(924.0) / 64,
};

} // namespace

void BondOrder6::add(const Eigen::Vector3d& direction)
{
    const double z = direction.z();
    const double z2 = z * z;
    const std::array<double, 7> polynomials = {
        ((231 * z2 - 315) * z2 + 105) * z2 - 5,
        z * ((33 * z2 - 30) * z2 + 5),
        (33 * z2 - 18) * z2 + 1,
        z * (11 * z2 - 3),
        11 * z2 - 1,
        z,
        1,
    };
    // By hand: the product of std::complex looks for infinities.
    double real = 1;
    double imaginary = 0;
    for (std::size_t m = 0; m < 7; ++m)
    {
        const double size = kFactors[m] * polynomials[m];
        sums_[m] += std::complex<double>(size * real, size * imaginary);
        const double turned = real * direction.x() - imaginary * direction.y();
        imaginary = real * direction.y() + imaginary * direction.x();
        real = turned;
    }
    ++bonds_;
}

void BondOrder6::add(const BondOrder6& other)
{
    bonds_ += other.bonds_;
    for (std::size_t m = 0; m < sums_.size(); ++m)
    {
        sums_[m] += other.sums_[m];
    }
}

double BondOrder6::q6() const
{
    if (bonds_ == 0)
    {
        return 0;
    }
    double squares = std::norm(sums_[0]);
    for (std::size_t m = 1; m < sums_.size(); ++m)
    {
        squares += 2 * std::norm(sums_[m]);
    }
    return std::sqrt(squares) / static_cast<double>(bonds_);
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
// Signs of determinants: rounded arithmetic with a bound on its error decides nearly always, else
// the determinant is computed without error, as a sum of doubles [Shewchuk 1997].
#include "geometry/exact_predicates.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace frostfill
{
namespace
{

constexpr double kUnit = 0x1p-53; // largest relative error of one operation

/// [1] Largest error of the rounded determinant over the same sum of absolute values
/// [Shewchuk 1997, figures 21 and 22]. Larger: more points take the long way. Smaller: wrong signs.
constexpr double kError2d = (3 + 16 * kUnit) * kUnit;
constexpr double kError3d = (7 + 56 * kUnit) * kUnit;

int signOf(double value)
{
    return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

/// A rounded result and what it lacks: the exact result is the sum of both.
struct Rounded
{
    double value;
    double lost;
};

Rounded exactSum(double a, double b)
{
    const double sum = a + b;
    const double bPart = sum - a;
    const double aPart = sum - bPart;
    return {sum, (a - aPart) + (b - bPart)};
}

Rounded exactProduct(double a, double b)
{
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

/// An exact number: the sum of its terms, which rise in magnitude, are not 0, and share no bits.
/// The last one thus has the sign of all.
template <std::size_t Capacity>
class Expansion
{
public:
    void push(double term)
    {
        if (term != 0)
        {
            terms_[count_++] = term;
        }
    }
    [[nodiscard]] Expansion operator-() const
    {
        Expansion negative;
        for (std::size_t i = 0; i < count_; ++i)
        {
            negative.push(-terms_[i]);
        }
        return negative;
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] double operator[](std::size_t i) const { return i < count_ ? terms_[i] : 0; }
    [[nodiscard]] int sign() const { return count_ == 0 ? 0 : signOf(terms_[count_ - 1]); }

private:
    std::array<double, Capacity> terms_; // only the first count_ are set
    std::size_t count_ = 0;
};

using Difference = Expansion<2>;

Difference difference(double a, double b)
{
    const Rounded rounded = exactSum(a, -b);
    Difference result;
    result.push(rounded.lost);
    result.push(rounded.value);
    return result;
}

// Merges the terms by magnitude and adds them up: [Shewchuk 1997, figure 8].
template <std::size_t N, std::size_t M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f)
{
    Expansion<N + M> result;
    double carry = 0;
    for (std::size_t i = 0, j = 0; i < e.count() || j < f.count();)
    {
        const bool takeE = j == f.count() || (i < e.count() && std::abs(e[i]) < std::abs(f[j]));
        const Rounded rounded = exactSum(carry, takeE ? e[i++] : f[j++]);
        result.push(rounded.lost);
        carry = rounded.value;
    }
    result.push(carry);
    return result;
}

// [Shewchuk 1997, figure 13]
template <std::size_t N>
Expansion<2 * N> operator*(const Expansion<N>& e, double factor)
{
    Expansion<2 * N> result;
    double carry = 0;
    for (std::size_t i = 0; i < e.count(); ++i)
    {
        const Rounded product = exactProduct(e[i], factor);
        const Rounded low = exactSum(carry, product.lost);
        const Rounded high = exactSum(product.value, low.value);
        result.push(low.lost);
        result.push(high.lost);
        carry = high.value;
    }
    result.push(carry);
    return result;
}

template <std::size_t N>
Expansion<4 * N> operator*(const Expansion<N>& e, const Difference& f)
{
    return e * f[0] + e * f[1];
}

/// a d - b c
Expansion<16> determinant(const Difference& a, const Difference& b, const Difference& c,
                          const Difference& d)
{
    return a * d + -(b * c);
}

std::array<Difference, 3> differences(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return {difference(a.x(), b.x()), difference(a.y(), b.y()), difference(a.z(), b.z())};
}

} // namespace

int orient2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
    const double left = (b.x() - a.x()) * (c.y() - a.y());
    const double right = (b.y() - a.y()) * (c.x() - a.x());
    const double rounded = left - right;
    const double magnitude = std::abs(left) + std::abs(right);
    if (std::abs(rounded) > kError2d * magnitude || magnitude == 0)
    {
        return signOf(rounded);
    }
    return determinant(difference(b.x(), a.x()), difference(b.y(), a.y()), difference(c.x(), a.x()),
                       difference(c.y(), a.y()))
        .sign();
}

int orient3d(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
             const Eigen::Vector3d& d)
{
    const Eigen::Vector3d u = b - a;
    const Eigen::Vector3d v = c - a;
    const Eigen::Vector3d w = d - a;
    double rounded = 0;
    double magnitude = 0;
    for (int i = 0; i < 3; ++i)
    {
        const double left = v[(i + 1) % 3] * w[(i + 2) % 3];
        const double right = v[(i + 2) % 3] * w[(i + 1) % 3];
        rounded += u[i] * (left - right);
        magnitude += std::abs(u[i]) * (std::abs(left) + std::abs(right));
    }
    if (std::abs(rounded) > kError3d * magnitude || magnitude == 0)
    {
        return signOf(rounded);
    }
    const auto [ux, uy, uz] = differences(b, a);
    const auto [vx, vy, vz] = differences(c, a);
    const auto [wx, wy, wz] = differences(d, a);
    const auto x = determinant(vy, vz, wy, wz) * ux;
    const auto y = determinant(vz, vx, wz, wx) * uy;
    const auto z = determinant(vx, vy, wx, wy) * uz;
    return (x + y + z).sign();
}

} // namespace frostfill

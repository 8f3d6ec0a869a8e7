// SPDX-License-Identifier: MIT
// Signs of determinants: rounded arithmetic with a bound on its error decides nearly always, else
// the determinant is computed without error, as a sum of doubles [Shewchuk 1997].
#include "geometry/exact_predicates.hpp"

#include <Eigen/Geometry>

#include <algorithm>
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

// Two convex sets in space that meet do so at the border of one of them, so triangles are compared
// edge by edge.
namespace
{

using Corners = TrianglePair::Corners;

std::size_t next(std::size_t corner)
{
    return (corner + 1) % 3;
}

Eigen::Vector2d project(const Eigen::Vector3d& p, int axis)
{
    return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// Along this axis the triangle is seen with an area; 3 if there is none.
int viewingAxis(const Corners& t)
{
    int axis = 0;
    while (axis < 3 && orient2d(project(t[0], axis), project(t[1], axis), project(t[2], axis)) == 0)
    {
        ++axis;
    }
    return axis;
}

/// On which side of a triangle's plane each corner of the other one lies.
std::array<int, 3> sidesOf(const Corners& plane, const Corners& points, int shared)
{
    std::array<int, 3> sides = {0, 0, 0};
    for (auto k = static_cast<std::size_t>(shared); k < 3; ++k)
    {
        sides[k] = orient3d(plane[0], plane[1], plane[2], points[k]);
    }
    return sides;
}

/// The corners that are not shared lie strictly on one side, so there is no other common point.
bool onOneSide(const std::array<int, 3>& sides, int shared)
{
    const auto isAll = [&](int side)
    { return std::all_of(sides.begin() + shared, sides.end(), [=](int s) { return s == side; }); };
    return isAll(1) || isAll(-1);
}

// In a plane: apart if one of the triangle's edges or the segment itself separates them.
bool meetsInPlane(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Corners& t)
{
    const int axis = viewingAxis(t);
    const std::array corners = {project(t[0], axis), project(t[1], axis), project(t[2], axis)};
    const Eigen::Vector2d from = project(p, axis);
    const Eigen::Vector2d to = project(q, axis);
    const int turn = orient2d(corners[0], corners[1], corners[2]);
    int left = 0;
    int right = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
        const Eigen::Vector2d& end = corners[next(k)];
        if (orient2d(corners[k], end, from) == -turn && orient2d(corners[k], end, to) == -turn)
        {
            return false;
        }
        const int side = orient2d(from, to, corners[k]);
        left += side > 0 ? 1 : 0;
        right += side < 0 ? 1 : 0;
    }
    return left < 3 && right < 3;
}

/// Whether the segment meets the triangle. `sides`: of its ends, with respect to the plane.
bool meets(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const std::array<int, 2>& sides,
           const Corners& t)
{
    if (sides[0] * sides[1] > 0)
    {
        return false;
    }
    if (sides[0] == 0 && sides[1] == 0)
    {
        return meetsInPlane(p, q, t);
    }
    // The line passes every edge on the same side.
    const std::array turns = {orient3d(p, q, t[0], t[1]), orient3d(p, q, t[1], t[2]),
                              orient3d(p, q, t[2], t[0])};
    const auto [least, most] = std::minmax({turns[0], turns[1], turns[2]});
    return least >= 0 || most <= 0;
}

/// The edges to test begin here. Edges at a single shared corner add nothing: what the triangles
/// have in common ends at the edge of one of them that is opposite to the corner.
std::size_t firstEdge(int shared)
{
    return shared == 1 ? 1 : 0;
}
std::size_t endOfEdges(int shared)
{
    return shared == 1 ? 2 : 3;
}

bool anyEdgeMeets(const Corners& edges, const std::array<int, 3>& sides, const Corners& t,
                  int shared)
{
    for (std::size_t k = firstEdge(shared); k < endOfEdges(shared); ++k)
    {
        if (meets(edges[k], edges[next(k)], {sides[k], sides[next(k)]}, t))
        {
            return true;
        }
    }
    return false;
}

} // namespace

bool hasArea(const Corners& triangle)
{
    return viewingAxis(triangle) < 3;
}

bool trianglesCross(const TrianglePair& pair)
{
    const auto& [a, b, shared] = pair;
    const std::array<int, 3> bSides = sidesOf(a, b, shared);
    if (shared < 3 && onOneSide(bSides, shared))
    {
        return false;
    }
    if (shared == 2)
    {
        // In one plane: a fold if both third corners are on the same side of the edge.
        const int axis = viewingAxis(a);
        const Eigen::Vector2d from = project(a[0], axis);
        const Eigen::Vector2d to = project(a[1], axis);
        return orient2d(from, to, project(a[2], axis)) == orient2d(from, to, project(b[2], axis));
    }
    const std::array<int, 3> aSides = sidesOf(b, a, shared);
    return shared == 3 || (!onOneSide(aSides, shared) && (anyEdgeMeets(a, aSides, b, shared) ||
                                                          anyEdgeMeets(b, bSides, a, shared)));
}

} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "geometry/exact_predicates.hpp"

#include "base/random.hpp"
#include "unit/geometry/exact_pair.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace frostfill
{
namespace
{

using test::real;
using test::Wide;
using Integers = test::WholePoint;

int signOf(Wide value)
{
    return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

Integers minus(const Integers& a, const Integers& b)
{
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

int exactSide(const Integers& a, const Integers& b, const Integers& c, const Integers& d)
{
    const Integers u = minus(b, a), v = minus(c, a), w = minus(d, a);
    const auto minor = [&](std::size_t i, std::size_t j)
    { return Wide{v[i]} * w[j] - Wide{v[j]} * w[i]; };
    return signOf(u[0] * minor(1, 2) + u[1] * minor(2, 0) + u[2] * minor(0, 1));
}

class Draws
{
public:
    explicit Draws(std::uint64_t seed) : seed_(seed) {}
    /// From -most to most.
    std::int64_t integer(std::int64_t most)
    {
        const double share = uniformRandom(seed_, 0, draw_++);
        return static_cast<std::int64_t>(
                   std::floor(share * (2.0 * static_cast<double>(most) + 1))) -
               most;
    }
    Integers integers(std::int64_t most)
    {
        const std::int64_t x = integer(most);
        const std::int64_t y = integer(most);
        return {x, y, integer(most)};
    }
    /// A point of the unit cube, moved by up to three steps of the last bit.
    Eigen::Vector3d near(Eigen::Vector3d p)
    {
        for (double& x : p)
        {
            for (std::int64_t steps = integer(3); steps != 0; steps += steps < 0 ? 1 : -1)
            {
                x = std::nextafter(x, steps < 0 ? -1e9 : 1e9);
            }
        }
        return p;
    }

private:
    std::uint64_t seed_;
    std::uint64_t draw_ = 0;
};

TEST(Orient3d, IsPositiveForAPointAboveACounterClockwiseTriangle)
{
    const Eigen::Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    EXPECT_EQ(orient3d(a, b, c, {5, -3, 1e-30}), 1);
    EXPECT_EQ(orient3d(a, b, c, {5, -3, -1e-30}), -1);
    EXPECT_EQ(orient3d(a, b, c, {5, -3, 0}), 0);
    EXPECT_EQ(orient3d(a, c, b, {5, -3, 1e-30}), -1);
}

TEST(Orient3d, AgreesWithIntegerArithmetic)
{
    Draws draws(1);
    for (const std::int64_t most :
         {std::int64_t{2}, std::int64_t{40}, std::int64_t{1} << 20, std::int64_t{1} << 38})
    {
        for (int trial = 0; trial < 20000; ++trial)
        {
            const auto [a, b, c, d] = std::array{draws.integers(most), draws.integers(most),
                                                 draws.integers(most), draws.integers(most)};
            ASSERT_EQ(orient3d(real(a), real(b), real(c), real(d)), exactSide(a, b, c, d));
        }
    }
}

TEST(Orient3d, AgreesWithIntegerArithmeticBesideThePlane)
{
    Draws draws(2);
    std::array<int, 3> seen = {};
    for (int trial = 0; trial < 50000; ++trial)
    {
        const Integers a = draws.integers(std::int64_t{1} << 34);
        const Integers u = draws.integers(std::int64_t{1} << 34);
        const Integers v = draws.integers(std::int64_t{1} << 34);
        const std::int64_t i = draws.integer(7);
        const std::int64_t j = draws.integer(7);
        const Integers off = draws.integers(1);
        Integers b = a, c = a, d = a;
        for (std::size_t k = 0; k < 3; ++k)
        {
            b[k] += u[k];
            c[k] += v[k];
            d[k] += i * u[k] + j * v[k] + (trial % 3 == 0 ? 0 : off[k]);
        }
        const int side = exactSide(a, b, c, d);
        ++seen.at(1 + side);
        ASSERT_EQ(orient3d(real(a), real(b), real(c), real(d)), side);
    }
    EXPECT_GT(seen[0], 5000);
    EXPECT_GT(seen[1], 5000);
    EXPECT_GT(seen[2], 5000);
}

// Coordinates of such different magnitude that their differences are no doubles.
TEST(Orient3d, SeesTheLastBitWhereDifferencesAreRounded)
{
    Draws draws(3);
    int flat = 0;
    for (int trial = 0; trial < 20000; ++trial)
    {
        // The plane is x + y = 2 z, in units of 2^-60.
        const auto onPlane = [&](int shift) -> Eigen::Vector3d
        {
            const auto x = static_cast<double>(draws.integer(1000) << shift);
            const auto y = static_cast<double>(draws.integer(1000) << shift);
            return Eigen::Vector3d(2 * x, 2 * y, x + y) * 0x1p-60;
        };
        const auto [a, b, c] = std::array<Eigen::Vector3d, 3>{onPlane(0), onPlane(50), onPlane(52)};
        Eigen::Vector3d d = onPlane(20);
        EXPECT_EQ(orient3d(a, b, c, d), 0);
        const int whole = orient3d(a, b, c, d + Eigen::Vector3d(0, 0, 1));
        d.z() = std::nextafter(d.z(), 1e9);
        ASSERT_EQ(orient3d(a, b, c, d), whole);
        flat += whole == 0 ? 1 : 0;
    }
    EXPECT_LT(flat, 200);
}

TEST(Orient3d, ChangesItsSignWithEachSwap)
{
    Draws draws(4);
    int decided = 0;
    for (int trial = 0; trial < 20000; ++trial)
    {
        // Within a few bits of the plane x + y + z = 1.
        const Eigen::Vector3d a = draws.near({0.1, 0.2, 0.7}), b = draws.near({0.3, 0.6, 0.1}),
                              c = draws.near({0.9, 0.05, 0.05}), d = draws.near({0.4, 0.35, 0.25});
        const int side = orient3d(a, b, c, d);
        decided += side != 0 ? 1 : 0;
        for (const int swapped : {orient3d(b, a, c, d), orient3d(c, b, a, d), orient3d(d, b, c, a),
                                  orient3d(a, c, b, d), orient3d(a, d, c, b), orient3d(a, b, d, c)})
        {
            ASSERT_EQ(swapped, -side);
        }
        for (const int turned : {orient3d(b, c, a, d), orient3d(c, a, b, d), orient3d(b, a, d, c)})
        {
            ASSERT_EQ(turned, side);
        }
    }
    EXPECT_GT(decided, 10000);
}

TEST(Orient2d, AgreesWithIntegerArithmeticNearALine)
{
    // The points around (1/2, 1/2) differ by steps of the last bit, 2^-53; the others lie on x = y.
    for (int i = 0; i < 256; ++i)
    {
        for (int j = 0; j < 256; ++j)
        {
            const Eigen::Vector2d a(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
            const auto whole = [](double x) { return Wide{static_cast<std::int64_t>(x * 0x1p53)}; };
            const Wide x = whole(a.x());
            const Wide y = whole(a.y());
            const Wide b = whole(12);
            const Wide c = whole(24);
            const int turn = signOf((b - x) * (c - y) - (b - y) * (c - x));
            ASSERT_EQ(orient2d(a, {12, 12}, {24, 24}), turn) << i << " " << j;
            ASSERT_EQ(orient2d({24, 24}, {12, 12}, a), -turn) << i << " " << j;
            ASSERT_EQ(orient2d({12, 12}, {24, 24}, a), turn) << i << " " << j;
        }
    }
}

TEST(Orient2d, AgreesWithIntegerArithmetic)
{
    Draws draws(6);
    for (const std::int64_t most : {std::int64_t{3}, std::int64_t{1} << 52})
    {
        for (int trial = 0; trial < 20000; ++trial)
        {
            const auto [a, b, c] =
                std::array{draws.integers(most), draws.integers(most), draws.integers(most)};
            const Integers u = minus(b, a);
            const Integers v = minus(c, a);
            ASSERT_EQ(orient2d(real(a).head<2>(), real(b).head<2>(), real(c).head<2>()),
                      signOf(Wide{u[0]} * v[1] - Wide{u[1]} * v[0]));
        }
    }
}

} // namespace
} // namespace frostfill

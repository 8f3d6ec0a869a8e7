// SPDX-License-Identifier: MIT
#include "mesh/polygon_cutter.hpp"

#include "base/random.hpp"
#include "unit/mesh/files/mesh_texts.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace frostfill
{
namespace
{

using test::Triangles;
using Points = std::vector<Eigen::Vector3d>;

Triangles cutAll(const Points& points)
{
    std::vector<std::uint32_t> corners(points.size());
    std::iota(corners.begin(), corners.end(), 0U);
    Triangles triangles;
    EXPECT_TRUE(PolygonCutter(points).cut(corners, triangles));
    return triangles;
}

Eigen::Vector3d areaOf(const Points& p, const std::array<std::uint32_t, 3>& t)
{
    return 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
}

/// The triangles cover the polygon once: each is wound like it, and their areas add up to its own.
void expectCovered(const Points& points)
{
    const Triangles triangles = cutAll(points);
    ASSERT_EQ(triangles.size(), points.size() - 2);
    Eigen::Vector3d whole = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
    {
        whole += 0.5 * (points[i] - points[0]).cross(points[i + 1] - points[0]);
    }
    double sum = 0;
    for (const auto& t : triangles)
    {
        EXPECT_GT(areaOf(points, t).dot(whole), 0);
        sum += areaOf(points, t).norm();
    }
    EXPECT_NEAR(sum, whole.norm(), 1e-9 * whole.norm());
}

/// In a plane that leans, far from the origin.
Points leaning(const Points& flat, double far)
{
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    Points result;
    for (const auto& p : flat)
    {
        result.emplace_back(turn * p + Eigen::Vector3d(far, -far, 0.5 * far));
    }
    return result;
}

TEST(PolygonCutter, CutsAConvexPolygonAsAFan)
{
    EXPECT_EQ(cutAll({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}),
              (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(PolygonCutter, CutsConcavePolygonsWithinTheirRim)
{
    const Points arrow = {{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {1, 0, 2}, {1, 0, 1}, {0, 0, 1}};
    const Points dart = {{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
    Points comb = {{0, -1, 0}, {20, -1, 0}};
    for (int tooth = 20; tooth > 0; --tooth)
    {
        comb.emplace_back(tooth - 0.5, 5, 0);
        comb.emplace_back(tooth - 1, 0, 0);
    }
    for (const Points& polygon : {arrow, dart, comb})
    {
        for (std::size_t first = 0; first < polygon.size(); ++first)
        {
            Points turned = polygon;
            std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first),
                        turned.end());
            expectCovered(turned);
            expectCovered(leaning(turned, 0));
            expectCovered(leaning(turned, 1e4));
            std::reverse(turned.begin(), turned.end());
            expectCovered(turned);
        }
    }
}

TEST(PolygonCutter, MakesNoFlatTriangleWhereCornersAreStraight)
{
    expectCovered(
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
    expectCovered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 2, 0}});
}

TEST(PolygonCutter, CutsAPolygonWithAHoleThatTouchesItself)
{
    // A square with a square hole, and a cut from one to the other.
    expectCovered({{0, 0, 0},
                   {4, 0, 0},
                   {4, 4, 0},
                   {0, 4, 0},
                   {0, 0, 0},
                   {1, 1, 0},
                   {1, 3, 0},
                   {3, 3, 0},
                   {3, 1, 0},
                   {1, 1, 0}});
}

TEST(PolygonCutter, CutsStarsOfRandomRadii)
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        Points star;
        const std::size_t count = 5 + seed % 60;
        for (std::size_t i = 0; i < count; ++i)
        {
            const double angle =
                2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
            const double radius = 0.2 + static_cast<double>(mixBits(97 * seed + i) % 1000) / 1000;
            star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
        }
        expectCovered(leaning(star, 10));
    }
}

TEST(PolygonCutter, KeepsTheRimOfWhatCrossesItselfOrHasNoArea)
{
    const Points bowTie = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}};
    const Points line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}};
    const Points point(6, Eigen::Vector3d::Ones());
    const Points huge = {{1e308, 0, 0}, {-1e308, 1e308, 0}, {0, -1e308, 1e308}, {1e308, 1e308, 0}};
    for (const Points& polygon : {bowTie, line, point, huge})
    {
        EXPECT_EQ(cutAll(polygon).size(), polygon.size() - 2);
    }
}

TEST(PolygonCutter, GivesUpOnAPolygonThatTakesTooLong)
{
    // A comb of a quarter of a million teeth, each of which hides the next.
    Points comb = {{0, -1, 0}, {250'000, -1, 0}};
    for (int tooth = 250'000; tooth > 0; --tooth)
    {
        comb.emplace_back(tooth - 0.5, tooth % 7 + 5, 0);
        comb.emplace_back(tooth - 1, mixBits(static_cast<std::uint64_t>(tooth)) % 4, 0);
    }
    std::vector<std::uint32_t> corners(comb.size());
    std::iota(corners.begin(), corners.end(), 0U);
    Triangles triangles;
    EXPECT_FALSE(PolygonCutter(comb).cut(corners, triangles));
}

} // namespace
} // namespace frostfill

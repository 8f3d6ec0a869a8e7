// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "geometry/exact_predicates.hpp"
#include "unit/geometry/exact_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

using test::real;
using Corners = TrianglePair::Corners;

Corners real(const test::WholeTriangle& t)
{
    return {real(t[0]), real(t[1]), real(t[2])};
}

class TriangleDraws
{
public:
    test::WholeTriangle triangle(std::int64_t below)
    {
        test::WholeTriangle t;
        do
        {
            for (test::WholePoint& corner : t)
            {
                corner = {whole(below), whole(below), whole(below)};
            }
        } while (!test::hasArea(t));
        return t;
    }

private:
    std::int64_t whole(std::int64_t below)
    {
        return static_cast<std::int64_t>(uniformRandom(1, 0, draw_++) * static_cast<double>(below));
    }
    std::uint64_t draw_ = 0;
};

bool crossing(const Corners& a, const Corners& b, int shared)
{
    const bool cross = trianglesCross({a, b, shared});
    EXPECT_EQ(trianglesCross({b, a, shared}), cross);
    return cross;
}

TEST(TrianglePair, CrossesAsSeparatingPlanesOfWholeNumbersSay)
{
    TriangleDraws draws;
    for (int shared = 0; shared < 3; ++shared)
    {
        for (const std::int64_t below : {2, 3, 5, 12})
        {
            std::array<int, 2> seen = {};
            for (int trial = 0; trial < 10000; ++trial)
            {
                const test::WholeTriangle a = draws.triangle(below);
                test::WholeTriangle b = draws.triangle(below);
                std::copy_n(a.begin(), shared, b.begin());
                if (!test::hasArea(b))
                {
                    continue;
                }
                const bool cross = test::wholeTrianglesCross(a, b, shared);
                ++seen.at(cross ? 1 : 0);
                ASSERT_EQ(crossing(real(a), real(b), shared), cross)
                    << "shared " << shared << ", below " << below << ", trial " << trial;
            }
            EXPECT_GT(seen[0], 20) << shared << " " << below;
            EXPECT_GT(seen[1], 20) << shared << " " << below;
        }
    }
}

const Corners kFlat = {Eigen::Vector3d(0, 0, 0), {4, 0, 0}, {0, 4, 0}};

TEST(TrianglePair, ThatTouchesInAPointCrosses)
{
    EXPECT_TRUE(crossing(kFlat, {Eigen::Vector3d(1, 1, 0), {1, 1, 1}, {2, 1, 1}}, 0));
    EXPECT_TRUE(crossing(kFlat, {Eigen::Vector3d(0, 0, 0), {-1, 0, 1}, {0, -1, 1}}, 0));
    EXPECT_FALSE(crossing(kFlat, {Eigen::Vector3d(1, 1, 1e-30), {1, 1, 1}, {2, 1, 1}}, 0));
    const double above = std::nextafter(2.0, 3.0);
    EXPECT_TRUE(crossing(kFlat, {Eigen::Vector3d(2, 2, 0), {2, 2, 1}, {3, 3, 1}}, 0));
    EXPECT_FALSE(crossing(kFlat, {Eigen::Vector3d(above, 2, 0), {2, 2, 1}, {3, 3, 1}}, 0));
}

TEST(TrianglePair, ThatSharesACornerOrAnEdgeDoesNotCrossThere)
{
    EXPECT_FALSE(crossing(kFlat, {Eigen::Vector3d(0, 0, 0), {-1, 0, 1}, {0, -1, 1}}, 1));
    EXPECT_FALSE(crossing(kFlat, {Eigen::Vector3d(0, 0, 0), {-1, 0, 0}, {0, -1, 0}}, 1));
    EXPECT_FALSE(crossing(kFlat, {Eigen::Vector3d(0, 0, 0), {4, 0, 0}, {0, 0, 1}}, 2));
    EXPECT_FALSE(crossing(kFlat, {Eigen::Vector3d(0, 0, 0), {4, 0, 0}, {1, -1, 0}}, 2));
}

TEST(TrianglePair, FoldedFlatOntoItselfCrosses)
{
    const Corners folded = {Eigen::Vector3d(0, 0, 0), {4, 0, 0}, {3, 9, 0}};
    EXPECT_TRUE(crossing(kFlat, folded, 2));
    const Corners nearly = {Eigen::Vector3d(0, 0, 0), {4, 0, 0}, {3, 9, 1e-30}};
    EXPECT_FALSE(crossing(kFlat, nearly, 2));
    EXPECT_TRUE(crossing(kFlat, kFlat, 3));
}

TEST(TrianglePair, ThatOverlapsAlongAnEdgeFromASharedCornerCrosses)
{
    EXPECT_TRUE(crossing(kFlat, {Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {0, 0, 1}}, 1));
    EXPECT_TRUE(crossing(kFlat, {Eigen::Vector3d(0, 0, 0), {9, 0, 0}, {0, 0, 1}}, 1));
}

TEST(TrianglePair, CrossesTheSameAfterAMoveAndAScaleWithoutRounding)
{
    TriangleDraws draws;
    for (int trial = 0; trial < 3000; ++trial)
    {
        const test::WholeTriangle a = draws.triangle(9);
        const test::WholeTriangle b = draws.triangle(9);
        for (const double scale : {0x1p-70, 0x1p60})
        {
            const auto moved = [&](const test::WholeTriangle& t)
            {
                Corners corners = real(t);
                for (Eigen::Vector3d& corner : corners)
                {
                    corner = (corner + Eigen::Vector3d(0x1p45, -0x1p40, 0x1p20)) * scale;
                }
                return corners;
            };
            ASSERT_EQ(crossing(moved(a), moved(b), 0), test::wholeTrianglesCross(a, b, 0));
        }
    }
}

TEST(TrianglePair, OfCornersOnALineHasNoArea)
{
    EXPECT_FALSE(hasArea({Eigen::Vector3d(0, 0, 0), {1, 2, 3}, {0x1p50, 0x1p51, 3 * 0x1p50}}));
    EXPECT_TRUE(hasArea({Eigen::Vector3d(0, 0, 0), {1, 2, 3}, {0x1p50, 0x1p51, 0x1p52}}));
    EXPECT_TRUE(
        hasArea({Eigen::Vector3d(0, 0, 0), {1, 2, 3}, {0x1p-50, 0x1p-49, 3.0001 * 0x1p-50}}));
    EXPECT_FALSE(hasArea({Eigen::Vector3d(1, 1, 1), {1, 1, 1}, {2, 3, 4}}));
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_bvh.hpp"

#include "base/random.hpp"
#include "mesh/interior/triangle_grid.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace frostfill
{
namespace
{

std::vector<std::uint32_t> allOf(const Surface& surface)
{
    std::vector<std::uint32_t> all(surface.size());
    std::iota(all.begin(), all.end(), 0U);
    return all;
}

/// Points all over the box and around it, then corners, middles of sides and of triangles.
std::vector<Eigen::Vector3d> pointsFor(const Surface& surface, std::size_t count)
{
    std::vector<Eigen::Vector3d> points;
    for (std::uint64_t k = 0; k < count; ++k)
    {
        const auto draw = [&](std::uint64_t n) { return 1.4 * uniformRandom(3, k, n) - 0.2; };
        points.emplace_back(surface.box().min() + surface.box().sizes().cwiseProduct(
                                                      Eigen::Vector3d(draw(0), draw(1), draw(2))));
        const auto t = static_cast<std::size_t>(k * surface.size() / count);
        const auto& [a, b, c] = surface[t].corner;
        points.insert(points.end(),
                      {a, (a + b) / 2, (a + b + c) / 3, a + 0.01 * surface.bound(t).normal});
    }
    points.emplace_back(surface.box().center()); // as far from many triangles
    return points;
}

/// Nearer than this a point lies on the surface, and rounding tells which triangle is nearest.
double roundingOf(const Surface& surface)
{
    const Eigen::AlignedBox3d& box = surface.box();
    return 1e-15 * box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
}

/// The list of all triangles is the oracle.
void expectNearest(const Surface& surface, std::size_t count, double size = 1)
{
    const std::vector<std::uint32_t> all = allOf(surface);
    const double rounding = roundingOf(surface);
    for (const Eigen::Vector3d& p : pointsFor(surface, count))
    {
        const SignedDistance expected = nearestDistance(surface, all, p);
        for (const double within :
             {std::numeric_limits<double>::infinity(), 0.05 * size, 1e-3 * size})
        {
            const SignedDistance found = nearestDistance(surface, p, within);
            if (std::abs(expected.value) > within * (1 + 1e-8))
            {
                EXPECT_EQ(found.value, std::numeric_limits<double>::infinity());
                continue;
            }
            if (std::abs(expected.value) < rounding)
            {
                EXPECT_NEAR(found.value, expected.value, 2 * rounding);
                EXPECT_LE((found.closest - expected.closest).norm(), 2 * rounding);
                continue;
            }
            EXPECT_EQ(found.value, expected.value);
            EXPECT_EQ(found.closest, expected.closest);
            EXPECT_EQ(found.feature, expected.feature);
        }
    }
}

TEST(TriangleBvh, FindsTheNearestTriangleToTheLastBit)
{
    expectNearest(Surface(shapes::torus(1, 0.4, 120, 40), Walls()), 300);
    expectNearest(Surface(shapes::box({-1, -1, -1}, {1, 1, 1}, 20), Walls()), 300);
}

TEST(TriangleBvh, FindsTheNearestOfFewAndOfManyAtOnePlace)
{
    for (const std::size_t count : {1, 2, 3, 5, 9, 17, 300})
    {
        TriangleMesh mesh;
        mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (std::size_t k = 0; k < count; ++k)
        {
            mesh.triangles.push_back(k % 2 == 0 ? std::array{0U, 1U, 2U} : std::array{0U, 3U, 1U});
        }
        expectNearest(Surface(mesh, Walls()), 20);
    }
}

TEST(TriangleBvh, FindsAllThatAreNearAndLeavesMostOut)
{
    const Surface surface(shapes::torus(1, 0.4, 120, 40), Walls());
    std::vector<std::uint32_t> found;
    std::size_t sum = 0;
    const auto points = pointsFor(surface, 200);
    for (const Eigen::Vector3d& p : points)
    {
        constexpr double kNear = 0.1;
        surface.tree().findNear(p, kNear, found);
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
        for (std::uint32_t id = 0; id < surface.size(); ++id)
        {
            const bool isNear = std::abs(signedDistance(surface, id, p).value) <= kNear;
            ASSERT_TRUE(!isNear || std::binary_search(found.begin(), found.end(), id)) << id;
        }
        sum += found.size();
    }
    EXPECT_LT(sum, points.size() * surface.size() / 20);
}

// Brute force with the test of one triangle, which is in double precision.
TEST(TriangleBvh, RejectsFourTrianglesAtOnceAsItWouldOne)
{
    const Surface surface(shapes::torus(1, 0.4, 120, 40), Walls());
    std::size_t found = 0;
    std::size_t expected = 0;
    for (const Eigen::Vector3d& p : pointsFor(surface, 100))
    {
        constexpr double kNear = 0.15;
        std::vector<bool> visited(surface.size(), false);
        surface.tree().forEachTriangleNear(p, kNear,
                                           [&](std::uint32_t id)
                                           {
                                               EXPECT_FALSE(visited[id]);
                                               visited[id] = true;
                                               ++found;
                                               return kNear;
                                           });
        for (std::uint32_t id = 0; id < surface.size(); ++id)
        {
            expected += surface.bound(id).mayBeWithin(kNear, p) ? 1 : 0;
        }
    }
    // The boxes reject some that the disc does not.
    EXPECT_LE(found, expected + expected / 100);
    EXPECT_GT(found, expected / 2);
}

TEST(TriangleBvh, FindsAllOnAWayAndFewerThanAroundIt)
{
    const Surface surface(shapes::torus(1, 0.4, 300, 100), Walls());
    std::size_t onWays = 0;
    std::size_t around = 0;
    for (std::uint64_t k = 0; k < 200; ++k)
    {
        const auto draw = [&](std::uint64_t n) { return uniformRandom(8, k, n); };
        const auto at = static_cast<std::uint32_t>(draw(0) * static_cast<double>(surface.size()));
        const TriangleBound& wall = surface.bound(at);
        const double radius = 0.02 + 0.1 * draw(1);
        // Along the wall, into it, and away from it.
        const Eigen::Vector3d direction =
            Eigen::Vector3d(draw(2) - 0.5, draw(3) - 0.5, draw(4) - 0.5).cross(wall.normal) +
            (static_cast<double>(k % 3) - 1) * 0.3 * wall.normal;
        const Eigen::Vector3d from = wall.centre + radius * wall.normal;
        const Eigen::Vector3d to = from + 0.25 * draw(5) * direction;
        const Eigen::Vector3d middle = (from + to) / 2;
        const double ball = radius + (to - from).norm() / 2;
        std::vector<std::uint32_t> found;
        surface.tree().forEachTriangleOnWay(from, to, radius,
                                            [&](std::uint32_t id) { found.push_back(id); });
        std::sort(found.begin(), found.end());
        onWays += found.size();
        std::vector<std::uint32_t> near;
        surface.tree().findNear(middle, ball, near);
        around += near.size();
        for (std::uint32_t id = 0; id < surface.size(); ++id)
        {
            const auto& [a, b, c] = surface[id].corner;
            bool isOnWay = false;
            for (int step = 0; step <= 20 && surface.bound(id).mayBeWithin(ball, middle); ++step)
            {
                const Eigen::Vector3d p = from + step / 20.0 * (to - from);
                isOnWay =
                    isOnWay || (closestPointOnTriangle(p, a, b, c).point - p).norm() <= radius;
            }
            ASSERT_TRUE(!isOnWay || std::binary_search(found.begin(), found.end(), id)) << k;
        }
    }
    EXPECT_GT(onWays, 0u);
    EXPECT_LT(3 * onWays, 2 * around);
}

TEST(TriangleBvh, EndsASearchWithANegativeLimit)
{
    const Surface surface(shapes::torus(1, 0.4, 120, 40), Walls());
    std::size_t visits = 0;
    surface.tree().forEachTriangleNear(surface[7].corner[0], 10,
                                       [&](std::uint32_t)
                                       {
                                           ++visits;
                                           return -1.0;
                                       });
    EXPECT_LE(visits, 4u); // those of a leaf
}

TEST(TriangleBvh, FindsTheNearestInMeshesOfAnySizeAndPlace)
{
    for (const double size : {1e-12, 1.0, 1e12})
    {
        TriangleMesh mesh = shapes::torus(1, 0.4, 60, 20);
        for (Eigen::Vector3d& vertex : mesh.vertices)
        {
            vertex = size * (vertex + Eigen::Vector3d(30, -10, 0.1));
        }
        expectNearest(Surface(mesh, Walls()), 100, size);
    }
}

TEST(TriangleBvh, HasEachTriangleInOneLeaf)
{
    const TriangleMesh human = builtInMesh("human");
    const TriangleBvh tree(human);
    std::vector<int> seen(human.triangles.size(), 0);
    for (std::uint32_t leaf = 0; leaf < tree.leaves(); ++leaf)
    {
        const auto triangles = tree.triangles(leaf);
        EXPECT_LE(triangles.size(), 4U);
        EXPECT_GE(triangles.size(), 2U);
        EXPECT_TRUE(std::is_sorted(triangles.begin(), triangles.end()));
        std::for_each(triangles.begin(), triangles.end(), [&](auto t) { ++seen[t]; });
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(seen.size()));
}

TEST(TriangleBvh, IsBalancedWhenAllCentroidsAreEqual)
{
    TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
    mesh.triangles.assign(1024, {0, 1, 2});
    const TriangleBvh tree(mesh);
    EXPECT_EQ(tree.leaves(), 256U);
    for (std::uint32_t i = 0; i < 1024; ++i)
    {
        EXPECT_EQ(tree.order()[i], i);
    }
}

TEST(TriangleBvh, IsTheSameWhateverTheThreadsThatMakeIt)
{
    // As many triangles as do not halve evenly.
    const TriangleMesh mesh = shapes::torus(2, 0.5, 173, 61);
    const TriangleBvh expected(mesh);
    Threads threads(3);
    const TriangleBvh tree(mesh, threads);
    EXPECT_TRUE(std::equal(tree.order().begin(), tree.order().end(), expected.order().begin()));
    EXPECT_EQ(tree.leaves(), expected.leaves());
}

TEST(TriangleBvh, LeavesNothingOutThatIsJustNearEnough)
{
    const Surface surface(shapes::torus(1, 0.4, 120, 40), Walls());
    std::vector<std::uint32_t> found;
    for (std::uint32_t id = 0; id < surface.size(); ++id)
    {
        // Boxes are nearest to what is beside them, along an axis.
        const auto& corners = surface[id].corner;
        for (int axis = 0; axis < 3; ++axis)
        {
            for (const double side : {-1e-4, 1e-4})
            {
                const Eigen::Vector3d& first =
                    *std::max_element(corners.begin(), corners.end(),
                                      [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
                                      { return side * a[axis] < side * b[axis]; });
                Eigen::Vector3d p = first;
                p[axis] += side;
                const double distance = std::abs(p[axis] - first[axis]);
                surface.tree().findNear(p, distance, found);
                ASSERT_TRUE(std::binary_search(found.begin(), found.end(), id)) << id;
            }
        }
    }
}

TEST(TriangleBvh, OfAMeshWithoutTrianglesFindsNone)
{
    std::vector<std::uint32_t> found = {7};
    TriangleBvh(TriangleMesh()).findNear({0, 0, 0}, 1, found);
    EXPECT_TRUE(found.empty());
}

// A grid asks the tree where its lists are long, and answers alike.
TEST(TriangleBvh, AnswersForAGridWhoseCellsHaveMany)
{
    const Surface surface(shapes::torus(1, 0.4, 240, 80), Walls());
    const TriangleGrid grid(surface, GridFrame::cover(surface.box(), 0.2, 0.5), 0.25);
    const std::vector<std::uint32_t> all = allOf(surface);
    const double rounding = roundingOf(surface);
    std::vector<std::uint32_t> found;
    std::size_t asked = 0;
    for (const Eigen::Vector3d& p : pointsFor(surface, 500))
    {
        const auto listed = grid.near(p);
        const SignedDistance expected = nearestDistance(surface, all, p);
        ASSERT_TRUE(!listed.empty() || std::abs(expected.value) > grid.reach());
        if (listed.empty())
        {
            continue;
        }
        const SignedDistance nearest = grid.nearest(p, listed);
        if (std::abs(expected.value) <= grid.reach())
        {
            EXPECT_NEAR(nearest.value, expected.value,
                        std::abs(expected.value) < rounding ? 2 * rounding : 0);
        }
        else
        {
            EXPECT_GT(std::abs(nearest.value), grid.reach());
        }
        const auto some = grid.near(p, 0.1, found);
        asked += some.data() == found.data() ? 1 : 0;
        for (const std::uint32_t id : all)
        {
            const bool isNear = std::abs(signedDistance(surface, id, p).value) <= 0.1;
            ASSERT_TRUE(!isNear || std::binary_search(some.begin(), some.end(), id)) << id;
        }
    }
    EXPECT_GT(asked, 1000U);
}

TEST(NearestPoint, OfASurfaceIsThatOfAListOfAllTriangles)
{
    const Surface surface(shapes::torus(1, 0.4, 120, 40), Walls());
    for (const Eigen::Vector3d& p : pointsFor(surface, 300))
    {
        double square = std::numeric_limits<double>::infinity();
        for (const SurfaceTriangle& t : surface.triangles())
        {
            const auto& [a, b, c] = t.corner;
            square = std::min(square, (p - closestPointOnTriangle(p, a, b, c).point).squaredNorm());
        }
        const double distance = std::sqrt(square);
        for (const double within : {1e9, 1.001 * distance + 1e-6})
        {
            const auto found = nearestPoint(surface.mesh(), surface.tree(), p, within);
            ASSERT_TRUE(found);
            EXPECT_EQ(found->distance, distance);
            EXPECT_EQ((p - found->point).squaredNorm(), square);
        }
        EXPECT_FALSE(nearestPoint(surface.mesh(), surface.tree(), p, 0.9 * distance));
    }
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "mesh/interior/triangle_rows.hpp"

#include "support/brute_distance.hpp"
#include "support/random_points.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace frostfill
{
namespace
{

using Cubes = std::set<std::tuple<int, int, int>>; // y down, z, x: the order of a search

constexpr double kReachOfRows = 1.3;

/// Those near the triangle, by looking at all.
Cubes byBruteForce(const GridFrame& frame, const Surface& surface)
{
    Cubes result;
    for (int z = 0; z < frame.count[2]; ++z)
    {
        for (int y = 0; y < frame.count[1]; ++y)
        {
            for (int x = 0; x < frame.count[0]; ++x)
            {
                if (distanceToSurface(surface, frame.centre(x, y, z)) <= kReachOfRows)
                {
                    result.insert({-y, z, x});
                }
            }
        }
    }
    return result;
}

Cubes byRows(const TriangleRows& rows, std::size_t& visited)
{
    Cubes result;
    rows.forEach(
        [&](int y, int z, CellRun most)
        {
            ++visited;
            const CellRun run = rows.run(y, z, most);
            for (int x = run.first; x <= run.last; ++x)
            {
                if (rows.near(x, y, z))
                {
                    result.insert({-y, z, x});
                }
            }
        });
    return result;
}

TriangleMesh triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
    TriangleMesh mesh;
    mesh.vertices = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

GridFrame gridAbout(const Surface& surface)
{
    return GridFrame::cover(surface.box(), 0.69, 0.5);
}

TEST(TriangleRows, HaveAllCubesNearATriangleHoweverLargeItIs)
{
    RandomPoints random(4);
    std::size_t large = 0;
    for (int k = 0; k < 40; ++k)
    {
        // Small ones, large ones, and long ones, some of them square to an axis.
        const double size = k % 4 == 0 ? 4 : 50;
        Eigen::Vector3d a = random.point(-size, size);
        Eigen::Vector3d b = random.point(-size, size);
        Eigen::Vector3d c =
            k % 3 == 0 ? Eigen::Vector3d(a + random.point(-1, 1)) : random.point(-size, size);
        if (k % 5 == 0)
        {
            const int axis = k / 5 % 3;
            b[axis] = c[axis] = a[axis];
        }
        const Surface surface(triangle(a, b, c));
        const GridFrame frame = gridAbout(surface);
        std::size_t visited = 0;
        EXPECT_EQ(byRows(TriangleRows(frame, surface, 0, kReachOfRows), visited),
                  byBruteForce(frame, surface))
            << k;
        large += static_cast<std::size_t>(frame.count[1]) * frame.count[2] > kLargeWindow ? 1 : 0;
    }
    EXPECT_GT(large, 10u);
}

TEST(TriangleRows, OfALongTriangleAreThoseBesideIt)
{
    const Surface surface(triangle({0, 0, 0}, {3000, 2000, 4000}, {3000, 2001, 4000}));
    const GridFrame frame = gridAbout(surface);
    std::size_t visited = 0;
    EXPECT_GT(byRows(TriangleRows(frame, surface, 0, kReachOfRows), visited).size(), 10000u);
    // The box has 1.7e7 rows. A row has the cubes on both sides, and one for each of three in z.
    EXPECT_LT(visited, 50000u);
}

TEST(TriangleRows, ASearchGoesOnFromTheRowWhereItEnded)
{
    const Surface surface(triangle({0, 0, 0}, {90, 60, 120}, {80, 60, 20}));
    const GridFrame frame = gridAbout(surface);
    const TriangleRows rows(frame, surface, 0, kReachOfRows);
    std::vector<std::array<int, 2>> all;
    rows.forEach([&](int y, int z, CellRun) { all.push_back({y, z}); });
    std::vector<std::array<int, 2>> found;
    std::uint64_t row = 0;
    bool isAgain = false;
    // Each row is found, and then passed over.
    while (rows.find(row,
                     [&](int y, int z, CellRun)
                     {
                         isAgain = !found.empty() && found.back() == std::array<int, 2>{y, z};
                         if (!isAgain)
                         {
                             found.push_back({y, z});
                         }
                         return !isAgain;
                     }))
    {
    }
    EXPECT_GT(all.size(), kLargeWindow);
    EXPECT_EQ(found, all);
    EXPECT_FALSE(rows.find(row, [](int, int, CellRun) { return true; }));
}

TEST(TriangleRows, ASearchAsksOnlyRowsThatAreWorthIt)
{
    // Of a large window and of a small one.
    for (const double size : {90.0, 3.0})
    {
        const Surface surface(triangle({0, 0, 0}, {size, size, size}, {size, size, size / 4}));
        const TriangleRows rows(gridAbout(surface), surface, 0, kReachOfRows);
        const auto isWorth = [](int y, int z) { return (3 * y + z) % 7 == 0; };
        const auto next = [&](int y, int z, int last, CellRun)
        {
            while (z <= last && !isWorth(y, z))
            {
                ++z;
            }
            return z;
        };
        std::vector<std::array<int, 2>> expected;
        rows.forEach(
            [&](int y, int z, CellRun)
            {
                if (isWorth(y, z))
                {
                    expected.push_back({y, z});
                }
            });
        std::vector<std::array<int, 2>> found;
        rows.forEach([&](int y, int z, CellRun) { found.push_back({y, z}); }, next);
        EXPECT_GT(expected.size(), 3u);
        EXPECT_EQ(found, expected);
        // A search that went on from its number would find the same row again.
        for (std::size_t k = 0; k < expected.size(); ++k)
        {
            std::uint64_t row = 0;
            std::size_t seen = 0;
            ASSERT_TRUE(rows.find(
                row, [&](int, int, CellRun) { return seen++ == k; }, next));
            ASSERT_TRUE(rows.find(
                row,
                [&](int y, int z, CellRun) {
                    return expected[k] == std::array<int, 2>{y, z};
                },
                [](int, int z, int, CellRun) { return z; }));
            std::size_t more = 0;
            rows.find(
                row, [&](int, int, CellRun) { return ++more > 1; }, next);
            EXPECT_EQ(more, std::min<std::size_t>(2, expected.size() - k));
        }
    }
}

} // namespace
} // namespace frostfill

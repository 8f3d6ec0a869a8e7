// SPDX-License-Identifier: MIT
#include "mesh/interior/near_surface.hpp"

#include "support/brute_distance.hpp"
#include "support/random_points.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <set>
#include <vector>

namespace frostfill
{
namespace
{

Threads one(1);

TEST(NearSurface, GroupsHaveEachTriangleOnceAndAreAsLongAsAllowed)
{
    const Surface surface(shapes::torus(1, 0.4, 40, 20));
    for (const double longest : {0.0, 0.1, 0.3, 9.0})
    {
        std::vector<std::uint32_t> all;
        std::size_t groups = 0;
        forEachGroup(surface, longest, one,
                     [&](const TriangleGroup& group)
                     {
                         ++groups;
                         all.insert(all.end(), group.triangles.begin(), group.triangles.end());
                         EXPECT_TRUE(group.triangles.size() == 1 ||
                                     group.box.sizes().maxCoeff() <= longest);
                         for (const std::uint32_t t : group.triangles)
                         {
                             for (const Eigen::Vector3d& corner : surface[t].corner)
                             {
                                 EXPECT_TRUE(group.box.contains(corner));
                             }
                         }
                     });
        const auto order = surface.tree().order();
        EXPECT_TRUE(std::equal(all.begin(), all.end(), order.begin(), order.end()));
        EXPECT_EQ(groups == all.size(), longest < 0.2) << longest;
        EXPECT_TRUE(longest < 9 || groups == all.size() / 16);
    }
}

TriangleMesh triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
    TriangleMesh mesh;
    mesh.vertices = {a, b, c};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

using Cells = std::set<std::array<int, 3>>;

TEST(NearSurface, HasAllCellsNearATriangleHoweverLargeItIs)
{
    constexpr double kDistance = 1.3;
    RandomPoints random(4);
    std::size_t large = 0;
    for (int k = 0; k < 40; ++k)
    {
        // Small ones, large ones, and long ones, some of them square to an axis.
        const double size = k % 4 == 0 ? 4 : 50;
        const Eigen::Vector3d a = random.point(-size, size);
        Eigen::Vector3d b = random.point(-size, size);
        Eigen::Vector3d c =
            k % 3 == 0 ? Eigen::Vector3d(a + random.point(-1, 1)) : random.point(-size, size);
        if (k % 5 == 0)
        {
            const int axis = k / 5 % 3;
            b[axis] = c[axis] = a[axis];
        }
        const Surface surface(triangle(a, b, c));
        const GridFrame frame = GridFrame::cover(surface.box(), 0.69, 0.5);
        Cells all;
        for (int z = 0; z < frame.count[2]; ++z)
        {
            for (int y = 0; y < frame.count[1]; ++y)
            {
                for (int x = 0; x < frame.count[0]; ++x)
                {
                    if (distanceToSurface(surface, frame.centre(x, y, z)) <= kDistance)
                    {
                        all.insert({x, y, z});
                    }
                }
            }
        }
        Cells found;
        forEachGroup(surface, frame.cell, one,
                     [&](const TriangleGroup& group)
                     {
                         forEachRunNear(frame, surface, group, kDistance,
                                        [&](int y, int z, CellRun run, auto&& isNear)
                                        {
                                            for (int x = run.first; x <= run.last; ++x)
                                            {
                                                if (isNear(x))
                                                {
                                                    found.insert({x, y, z});
                                                }
                                            }
                                        });
                     });
        EXPECT_EQ(found, all) << k;
        large += all.size() > 10000 ? 1 : 0;
    }
    EXPECT_GT(large, 5u);
}

TEST(NearSurface, OfALongTriangleLooksAtRowsBesideIt)
{
    const Surface surface(triangle({0, 0, 0}, {3000, 2000, 4000}, {3000, 2001, 4000}));
    const GridFrame frame = GridFrame::cover(surface.box(), 0.69, 0.5);
    std::size_t runs = 0;
    std::size_t near = 0;
    forEachGroup(surface, frame.cell, one,
                 [&](const TriangleGroup& group)
                 {
                     forEachRunNear(frame, surface, group, 1.3,
                                    [&](int, int, CellRun run, auto&& isNear)
                                    {
                                        ++runs;
                                        for (int x = run.first; x <= run.last; ++x)
                                        {
                                            near += isNear(x) ? 1 : 0;
                                        }
                                    });
                 });
    EXPECT_GT(near, 10000u);
    EXPECT_LT(runs, 300000u); // of eight cells at most; its box has 1.7e7 rows
}

/// How many cells, by their number, are found near the surface.
std::vector<std::atomic<int>> countNear(const Surface& surface, const GridFrame& frame,
                                        double distance, int threadCount)
{
    Threads threads(threadCount);
    std::vector<std::atomic<int>> count(frame.size());
    forEachGroup(surface, frame.cell, threads,
                 [&](const TriangleGroup& group)
                 {
                     forEachRunNear(frame, surface, group, distance,
                                    [&](int y, int z, CellRun run, auto&& isNear)
                                    {
                                        for (int x = run.first; x <= run.last; ++x)
                                        {
                                            count[frame.index(x, y, z)] += isNear(x) ? 1 : 0;
                                        }
                                    });
                 });
    return count;
}

TEST(NearSurface, HasTheCellsWhoseMiddleIsNearSomeTriangleHoweverManyThreadsLook)
{
    // Large triangles, small ones, and both.
    for (const TriangleMesh& mesh : {shapes::box({-3, -3, -3}, {3, 3, 3}),
                                     shapes::torus(3, 1.5, 80, 40), shapes::torus(3, 1.5, 9, 200)})
    {
        const Surface surface(mesh);
        const GridFrame frame = GridFrame::cover(surface.box(), 0.37, 0.5);
        for (const double distance : {0.0, 0.2, 1.1})
        {
            const auto byOne = countNear(surface, frame, distance, 1);
            const auto byThree = countNear(surface, frame, distance, 3);
            std::size_t near = 0;
            for (int z = 0; z < frame.count[2]; ++z)
            {
                for (int y = 0; y < frame.count[1]; ++y)
                {
                    for (int x = 0; x < frame.count[0]; ++x)
                    {
                        const std::size_t cell = frame.index(x, y, z);
                        const bool isNear =
                            distanceToSurface(surface, frame.centre(x, y, z)) <= distance;
                        ASSERT_EQ(byOne[cell] > 0, isNear) << x << ' ' << y << ' ' << z;
                        ASSERT_EQ(byThree[cell], byOne[cell]);
                        near += isNear ? 1 : 0;
                    }
                }
            }
            EXPECT_EQ(near > 100, distance > 0);
        }
    }
}

} // namespace
} // namespace frostfill

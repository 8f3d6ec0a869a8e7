// SPDX-License-Identifier: MIT
#include "mesh/interior/group_rows.hpp"

#include "mesh/interior/near_surface.hpp"
#include "support/brute_distance.hpp"
#include "support/shapes.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <vector>

namespace frostfill
{
namespace
{

using CellSet = std::set<std::array<int, 3>>;

TEST(GroupRows, HaveTheCubesThatEachTriangleHas)
{
    constexpr double kReach = 1.3;
    const Surface surface(shapes::torus(3, 1, 60, 30));
    const GridFrame frame = GridFrame::cover(surface.box(), 0.69, 0.5); // which cuts some off
    std::size_t large = 0;
    forEachGroup(surface, 0.69,
                 [&](const TriangleGroup& group)
                 {
                     CellSet expected;
                     for (const std::uint32_t t : group.triangles)
                     {
                         const TriangleRows rows(frame, surface, t, kReach);
                         rows.forEach(
                             [&](int y, int z, CellRun most)
                             {
                                 const CellRun run = rows.run(y, z, most);
                                 for (int x = run.first; x <= run.last; ++x)
                                 {
                                     if (rows.near(x, y, z))
                                     {
                                         expected.insert({x, y, z});
                                     }
                                 }
                             });
                     }
                     CellSet found;
                     const GroupRows rows(frame, surface, group, kReach);
                     rows.forEach(
                         [&](int y, int z, CellRun run)
                         {
                             for (int x = run.first; x <= run.last; ++x)
                             {
                                 if (rows.near(x, y, z))
                                 {
                                     found.insert({x, y, z});
                                 }
                             }
                         });
                     ASSERT_EQ(found, expected);
                     large += group.triangles.size() > 1 ? 1 : 0;
                 });
    EXPECT_GT(large, 100u);
}

TEST(GroupRows, AreFoundFromTheTopDownAndFromAnyRowOn)
{
    const Surface surface(shapes::torus(3, 1, 60, 30));
    const GridFrame frame = GridFrame::cover(surface.box(), 0.69, 0.5);
    TriangleGroup group;
    forEachGroup(surface, 0.69,
                 [&](const TriangleGroup& one)
                 { group = one.triangles.size() > group.triangles.size() ? one : group; });
    const GroupRows rows(frame, surface, group, 1.3);
    std::vector<CellRow> all;
    rows.forEach([&](int y, int z, CellRun) { all.push_back({y, z}); });
    ASSERT_GT(all.size(), 10u);
    for (std::size_t i = 1; i < all.size(); ++i)
    {
        EXPECT_TRUE(all[i - 1].isBefore(all[i]));
        EXPECT_FALSE(all[i].isBefore(all[i - 1]));
    }
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        std::size_t next = i;
        rows.find(all[i],
                  [&](int y, int z, CellRun)
                  {
                      EXPECT_EQ(y, all[next].y);
                      EXPECT_EQ(z, all[next].z);
                      return ++next == i + 3;
                  });
        EXPECT_EQ(next, std::min(i + 3, all.size()));
    }
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

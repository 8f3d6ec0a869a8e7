// SPDX-License-Identifier: MIT
#include "simulation/reach/group_rows.hpp"

#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

#include <set>

namespace frostfill
{
namespace
{

using CubeSet = std::set<std::array<int, 3>>;

TEST(GroupRows, HaveTheCubesThatEachTriangleHas)
{
    constexpr double kReach = 1.3;
    const Surface surface(shapes::torus(3, 1, 60, 30));
    const GridFrame frame = GridFrame::cover(surface.box(), 0.69, 0.5); // which cuts some off
    std::size_t large = 0;
    forEachGroup(surface, 0.69,
                 [&](const TriangleGroup& group)
                 {
                     CubeSet expected;
                     for (const std::uint32_t t : group.triangles)
                     {
                         const TriangleRows rows(frame, surface, t, kReach);
                         rows.forEach(
                             [&](int y, int z, VoxelRun most)
                             {
                                 const VoxelRun run = rows.run(y, z, most);
                                 for (int x = run.first; x <= run.last; ++x)
                                 {
                                     if (rows.near(x, y, z))
                                     {
                                         expected.insert({x, y, z});
                                     }
                                 }
                             });
                     }
                     CubeSet found;
                     const GroupRows rows(frame, surface, group, kReach);
                     rows.forEach(
                         [&](int y, int z, VoxelRun run)
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

/// Each cube's distance to the surface, by looking at all triangles.
std::vector<double> distances(const VoxelLayout& layout, const Surface& surface)
{
    std::vector<double> result(64 * layout.words);
    layout.forEachWord(
        [&](VoxelWord w)
        {
            layout.forEachCube(w,
                               [&](int x, int y, int z)
                               {
                                   result[64 * w.word + static_cast<std::size_t>(x % 64)] =
                                       reach::distanceToSurface(surface,
                                                                layout.frame.centre(x, y, z));
                               });
        });
    return result;
}

TEST(ReachMap, CubesFartherThanADistanceAreThoseWhoseMiddleIs)
{
    // Large triangles, small ones, and both.
    for (const TriangleMesh& mesh : {shapes::box({-3, -3, -3}, {3, 3, 3}),
                                     shapes::torus(3, 1.5, 80, 40), shapes::torus(3, 1.5, 9, 200)})
    {
        const reach::Object object(mesh);
        ReachMap::Unblocked unblocked;
        const ReachMap map(object.surface, object.inside, {1, 1}, {}, {}, &unblocked);
        ASSERT_TRUE(map.active());
        const std::vector<double> far = distances(map.layout(), object.surface);
        for (const double distance : {0.2, 0.9, 1.4})
        {
            for (const VoxelBits& among : {unblocked.all, map.reached()})
            {
                VoxelBits expected = among;
                for (std::size_t cube = 0; cube < far.size(); ++cube)
                {
                    expected[cube / 64] &= ~(std::uint64_t{far[cube] <= distance} << cube % 64);
                }
                EXPECT_EQ(map.cubesFartherThan(distance, among), expected);
            }
        }
        const double blocked = map.exclusion(1) - kHalfDiagonal * map.layout().frame.cell;
        EXPECT_EQ(map.cubesFartherThan(blocked, unblocked.all), unblocked.all);
        EXPECT_EQ(unblocked.inside, map.reached()); // before anything comes to rest
    }
}

TEST(VoxelLayout, TheFirstRowWithACubeOfASetIsTheFirstThatHasAny)
{
    const VoxelLayout layout(GridFrame{Eigen::Vector3d::Zero(), 1, {150, 4, 40}});
    VoxelBits set(layout.words, 0);
    reach::Random random(3);
    for (int k = 0; k < 30; ++k)
    {
        const VoxelWord cube = layout.at(static_cast<int>(random.uniform(0, 150)),
                                         static_cast<int>(random.uniform(0, 4)),
                                         static_cast<int>(random.uniform(0, 40)));
        set[cube.word] |= cube.bits;
    }
    for (int k = 0; k < 3000; ++k)
    {
        const int y = static_cast<int>(random.uniform(0, 4));
        const int z = static_cast<int>(random.uniform(0, 40));
        const int lastZ = static_cast<int>(random.uniform(z, 40));
        const int first = static_cast<int>(random.uniform(0, 150));
        const int last = std::min(149, first + static_cast<int>(random.uniform(0, 70)));
        int expected = z;
        while (expected <= lastZ && !layout.any(set, y, expected, first, last))
        {
            ++expected;
        }
        ASSERT_EQ(layout.firstRow(set, y, z, lastZ, first, last), expected);
    }
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

#include <set>

namespace frostfill
{
namespace
{

TEST(ReachMap, TrianglesSideBySideFindWhatEachFindsByItself)
{
    for (const TriangleMesh& mesh :
         {shapes::torus(3, 1.5, 200, 100), shapes::torus(3, 1.5, 60, 200)})
    {
        const reach::Object object(mesh);
        ReachMap map(object.surface, object.inside, {0.4, 0.4}, {}, {});
        ASSERT_TRUE(map.active() && map.flood({}));
        reach::Random random(11);
        std::size_t together = 0;
        for (int round = 0; round < 3; ++round)
        {
            std::set<std::array<int, 3>> asked;
            std::set<std::array<int, 3>> askedTogether;
            const auto confirms = [&](std::set<std::array<int, 3>>& cubes)
            {
                return [&cubes, round](int x, int y, int z)
                {
                    cubes.insert({x, y, z});
                    return (7 * x + 5 * y + 3 * z) % (2 + round) == 0;
                };
            };
            forEachGroup(object.surface, map.layout().frame.cell,
                         [&](const TriangleGroup& group)
                         {
                             const CellRow from = {static_cast<int>(random.uniform(2, 20)),
                                                   static_cast<int>(random.uniform(-3, 20))};
                             const std::size_t size = group.triangles.size();
                             std::vector<CubeNumber> alone(size, kNoCube);
                             std::vector<CubeNumber> found(size, kNoCube);
                             for (std::size_t k = 0; k < size; ++k)
                             {
                                 map.findNear({group.triangles.subspan(k, 1), {}}, from,
                                              confirms(asked),
                                              [&](std::size_t, VoxelWord cube)
                                              { alone[k] = numberOf(cube); });
                             }
                             map.findNear(group, from, confirms(askedTogether),
                                          [&](std::size_t k, VoxelWord cube)
                                          {
                                              EXPECT_EQ(found[k], kNoCube);
                                              found[k] = numberOf(cube);
                                          });
                             EXPECT_EQ(found, alone);
                             together += size > 1 ? 1 : 0;
                         });
            EXPECT_EQ(askedTogether, asked);
            EXPECT_GT(asked.size(), 100u);
        }
        EXPECT_GT(together, 50u);
    }
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
                                       distanceToSurface(surface, layout.frame.centre(x, y, z));
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

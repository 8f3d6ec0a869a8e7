// SPDX-License-Identifier: MIT
#include "simulation/reach/clear_search.hpp"

#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

namespace frostfill::reach
{
namespace
{

constexpr double kEdge = 0.66;
constexpr std::uint32_t kAll = 0xffffffff;

/// Spheres at random, closer than they could lie: cubes between them are covered by several.
struct Crowd
{
    explicit Crowd(std::uint64_t seed)
        : object(cubeOfSide(10)), resting(GridFrame::cover(object.surface.box(), 2, 2)),
          random(seed)
    {
        for (std::uint32_t id = 0; id < 120; ++id)
        {
            balls.push_back({random.point(-4, 4)});
            resting.insert(id, balls.back().centre, 1);
        }
    }

    /// The depth of p in what excludes it; negative when p is clear by that much.
    [[nodiscard]] double depth(const Eigen::Vector3d& p) const
    {
        double deepest = 1 - distanceToSurface(object.surface, p);
        for (const Ball& ball : balls)
        {
            deepest = std::max(deepest, 2 - (p - ball.centre).norm());
        }
        return deepest;
    }

    Object object;
    SphereGrid resting;
    Random random;
    std::vector<Ball> balls;
};

// The oracle samples the cube's points one by one, against every sphere and every triangle.
TEST(ClearSearch, OverlooksNoClearPointAndFindsNoneWhereAllIsExcluded)
{
    int clear = 0;
    int covered = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
    {
        Crowd crowd(seed);
        const ClearSearch search(crowd.resting, crowd.object.grid, 1);
        for (int k = 0; k < 150; ++k)
        {
            const Eigen::Vector3d middle = crowd.random.point(-4.6, 4.6);
            double shallowest = 1e300;
            for (int sample = 0; sample < 200; ++sample)
            {
                const Eigen::Vector3d p = middle + crowd.random.point(-kEdge / 2, kEdge / 2);
                shallowest = std::min(shallowest, crowd.depth(p));
            }
            const bool mayBeClear = search.mayHold(middle, kEdge, kAll);
            if (shallowest < 0)
            {
                ++clear;
                EXPECT_TRUE(mayBeClear) << "seed " << seed << " cube " << k;
            }
            else if (shallowest > 0.35) // more than a part's diagonal, and what sampling misses
            {
                ++covered;
                EXPECT_FALSE(mayBeClear) << "seed " << seed << " cube " << k;
            }
        }
    }
    EXPECT_GT(clear, 10);
    EXPECT_GT(covered, 20);
}

// The same cube, whose walls have 16,000 triangles a side.
TEST(ClearSearch, AnswersAlikeWhereWallsAreDense)
{
    Crowd crowd(5);
    const Object dense(cubeOfSide(10, 90));
    const ClearSearch search(crowd.resting, crowd.object.grid, 1);
    const ClearSearch among(crowd.resting, dense.grid, 1);
    std::size_t walled = 0;
    int clear = 0;
    for (int k = 0; k < 3000; ++k)
    {
        const Eigen::Vector3d middle = crowd.random.point(-4.6, 4.6);
        const bool expected = search.mayHold(middle, kEdge, kAll);
        EXPECT_EQ(among.mayHold(middle, kEdge, kAll), expected) << middle.transpose();
        clear += expected ? 1 : 0;
        walled += dense.grid.near(middle).size() > TriangleGrid::kShortList ? 1 : 0;
    }
    EXPECT_GT(walled, 1000U);
    EXPECT_GT(clear, 100);
}

// Four balls about the corners of a tetrahedron cover a cube that none of them covers alone.
TEST(ClearSearch, CubeThatOnlySeveralCoverTogetherIsCovered)
{
    const Object object(cubeOfSide(20));
    SphereGrid resting(GridFrame::cover(object.surface.box(), 2, 2));
    const std::vector<Eigen::Vector3d> corners = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (std::uint32_t id = 0; id < corners.size(); ++id)
    {
        const Eigen::Vector3d centre = corners[id].normalized() * 1.75;
        resting.insert(id, centre, 1);
        const Eigen::Vector3d farthest = centre.cwiseAbs().array() + kEdge / 2;
        EXPECT_GT(farthest.norm(), 2);
    }
    const ClearSearch search(resting, object.grid, 1);
    EXPECT_FALSE(search.mayHold({0, 0, 0}, kEdge, 4));
    EXPECT_TRUE(search.mayHold({0, 0, 0}, kEdge, 3)) << "without the last";
}

} // namespace
} // namespace frostfill::reach

// SPDX-License-Identifier: MIT
#include "simulation/reach/clear_search.hpp"

#include "unit/simulation/reach/reach_scene.hpp"

#include <gtest/gtest.h>

namespace frostfill::reach
{
namespace
{

constexpr double kEdge = 0.66;
constexpr double kOverlap = 1e-3;

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
        double deepest = 1 - kOverlap - distanceToSurface(object.surface, p);
        for (const Ball& ball : balls)
        {
            deepest = std::max(deepest, 2 - kOverlap - (p - ball.centre).norm());
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
        ClearSearch search(crowd.resting, crowd.object.surface, crowd.object.grid, 1, kOverlap);
        for (int k = 0; k < 150; ++k)
        {
            const Eigen::Vector3d middle = crowd.random.point(-4.6, 4.6);
            double shallowest = 1e300;
            for (int sample = 0; sample < 200; ++sample)
            {
                const Eigen::Vector3d p = middle + crowd.random.point(-kEdge / 2, kEdge / 2);
                shallowest = std::min(shallowest, crowd.depth(p));
            }
            const bool mayBeClear = search.mayBeClear(middle, kEdge);
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
    ClearSearch search(crowd.resting, crowd.object.surface, crowd.object.grid, 1, kOverlap);
    ClearSearch among(crowd.resting, dense.surface, dense.grid, 1, kOverlap);
    std::size_t walled = 0;
    int clear = 0;
    for (int k = 0; k < 3000; ++k)
    {
        const Eigen::Vector3d middle = crowd.random.point(-4.6, 4.6);
        const bool expected = search.mayBeClear(middle, kEdge);
        EXPECT_EQ(among.mayBeClear(middle, kEdge), expected) << middle.transpose();
        clear += expected ? 1 : 0;
        walled += dense.grid.near(middle).size() > TriangleGrid::kShortList ? 1 : 0;
    }
    EXPECT_GT(walled, 1000U);
    EXPECT_GT(clear, 100);
}

// What one search remembers of walls is no wall of another object, on the same thread.
TEST(ClearSearch, ForgetsTheWallsOfOtherObjects)
{
    const Object small(cubeOfSide(18));
    const Object large(cubeOfSide(20));
    const SphereGrid nothing(GridFrame::cover(large.surface.box(), 2, 2));
    const ClearSearch inSmall(nothing, small.surface, small.grid, 1, kOverlap);
    const ClearSearch inLarge(nothing, large.surface, large.grid, 1, kOverlap);
    const Eigen::Vector3d place(0.3, 0.2, 8.9);
    EXPECT_FALSE(inSmall.mayBeClear(place, kEdge));
    EXPECT_TRUE(inLarge.mayBeClear(place, kEdge)); // a wall is near, but not that near
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
    ClearSearch search(resting, object.surface, object.grid, 1, kOverlap);
    EXPECT_FALSE(search.mayBeClear({0, 0, 0}, kEdge));
    search.ignore(0);
    EXPECT_TRUE(search.mayBeClear({0, 0, 0}, kEdge));
}

} // namespace
} // namespace frostfill::reach

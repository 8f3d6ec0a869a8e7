// SPDX-License-Identifier: MIT
#include "simulation/paper/paper_engine.hpp"
#include "support/shapes.hpp"
#include "support/small_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

class PaperDiscards : public ::testing::Test
{
protected:
    void rest(const Eigen::Vector3d& place, std::uint32_t group)
    {
        world->spheres.addResting(place, 1, group);
    }
    std::unique_ptr<World> world = smallWorld(shapes::box({-10, -10, -10}, {10, 10, 10}));
};

// PAPER, eq. 3: a group goes when all of it lies deeper than epsilon below the lowest sphere of the
// last group.
TEST_F(PaperDiscards, ByHeightGoWholeGroupsBelowTheLowestOfTheLast)
{
    rest({0, -9, 0}, 0);
    rest({3, -8, 0}, 0);
    rest({0, -2, 0}, 1);
    rest({0, 1, 0}, 2);
    rest({3, 3, 0}, 2);
    EXPECT_EQ(discardByHeight(*world, 0, 5, 4), 2u);
    EXPECT_EQ(world->spheres.discardedCount(), 2u);
    EXPECT_EQ(world->spheres.state(1), SphereState::discarded);
    EXPECT_EQ(world->spheres.state(2), SphereState::frozen);
    EXPECT_EQ(discardByHeight(*world, 2, 5, 2.9), 3u) << "one group more within less";
    EXPECT_EQ(discardByHeight(*world, 3, 5, -100), 3u) << "the last group stays";
}

TEST_F(PaperDiscards, ByHeightGoInTheOrderInWhichTheyCame)
{
    rest({0, 0, 0}, 0); // keeps those behind it
    rest({3, -9, 0}, 1);
    rest({6, 1, 0}, 2);
    EXPECT_EQ(discardByHeight(*world, 0, 3, 4), 0u);
    EXPECT_EQ(world->spheres.discardedCount(), 0u);
}

// PAPER: a polygon goes when the rays from all of its vertices along their normals soon enter a
// sphere. Spheres in the corners of the floor cover its two triangles, and no corner of the roof.
TEST_F(PaperDiscards, PolygonsGoWhenAllTheirVerticesAreCovered)
{
    rest({-9, -9, -9}, 0);
    rest({9, -9, -9}, 0);
    rest({9, -9, 9}, 0);
    EXPECT_LE(discardCoveredPolygons(*world, 1), 1u) << "three corners make one triangle at most";
    rest({-9, -9, 9}, 0);
    discardCoveredPolygons(*world, 1);
    EXPECT_EQ(world->discardedPolygons, 2u);
    for (std::uint32_t t = 0; t < world->surface.size(); ++t)
    {
        const bool isFloor = world->surface.bound(t).normal.y() > 0.5;
        EXPECT_EQ(world->polygons[t] == PolygonState::discarded, isFloor) << t;
    }
}

// The ray enters a sphere of radius 1 in the corner after sqrt(3) - 1.
TEST_F(PaperDiscards, PolygonsStayWhenTheSpheresAreFarther)
{
    for (const double x : {-9.0, 9.0})
    {
        for (const double z : {-9.0, 9.0})
        {
            rest({x, -9, z}, 0);
        }
    }
    EXPECT_EQ(discardCoveredPolygons(*world, std::sqrt(3.0) - 1 - 1e-9), 0u);
    EXPECT_EQ(discardCoveredPolygons(*world, std::sqrt(3.0) - 1 + 1e-9), 2u);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "simulation/release/site_lattice.hpp"

#include "base/random.hpp"
#include "simulation/world/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace frostfill
{
namespace
{

class SiteLatticeOf : public ::testing::TestWithParam<const char*>
{
};

TEST_P(SiteLatticeOf, OpensTheSitesThatAreFarEnoughInside)
{
    Scene scene = presetScene(Preset::fast, GetParam());
    scene.spheres.count.reset();
    const TriangleMesh mesh = builtInMesh(GetParam());
    scene.spheres.radius = boundingBox(mesh).sizes().maxCoeff() / 40;
    const World world(scene, mesh);
    Threads two(2);
    // The last ones have cells as coarse as for a larger one: sites side by side may lie on both
    // sides of a wall, and some outside are open.
    for (const auto& [radius, coarsest] :
         {std::pair{1.0, 0.0}, {0.6, 0.0}, {0.3, 0.45}, {0.3, 0.7}, {0.3, 2.0}})
    {
        const SiteLattice sites(world.surface, world.inside, radius, two, coarsest);
        const double least = sites.depth();
        EXPECT_LE(least, radius - sites.halfDiagonal()) << "no place is missed";
        std::size_t open = 0;
        for (std::size_t site = SiteLattice::begin(); site < sites.end(); ++site)
        {
            // A lattice is quick because most sites are decided by those beside them. Each alone:
            const Eigen::Vector3d centre = sites.centre(site);
            const bool isFarEnough = sites.lattice().contains(centre) && // not beyond a row's end
                                     world.inside.distance(centre) >= least;
            ASSERT_EQ(sites.isOpen(site), isFarEnough) << site;
            open += isFarEnough ? 1 : 0;
        }
        EXPECT_GT(open, 1000U);
    }
}

TEST(SiteLattice, HasNoMoreCellsThanItsNumbersCount)
{
    // A needle of 2e7 largest radii, whose smallest spheres are a hundredth, and a slanted one.
    for (const auto& [box, inReach] : {std::pair{Eigen::Vector3d(2e7, 3, 3), 2e8},
                                       {Eigen::Vector3d(2e7, 2e7, 3), 2e8},
                                       {Eigen::Vector3d(2e7, 2e7, 3), 1.0}})
    {
        for (const double radius : {1.0, 0.01, 1e-6})
        {
            const double cell = cellOfSites(box, inReach, radius);
            EXPECT_GE(cell, kSiteCell * radius);
            EXPECT_LE(box.maxCoeff() / cell, std::numeric_limits<int>::max());
            EXPECT_LE(inReach / (cell * cell * cell), kMaxSites);
            EXPECT_TRUE(radius < 1 || cell == kSiteCell);
            const GridFrame frame =
                GridFrame::cover(Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), box), cell, 0);
            EXPECT_NEAR(frame.count[0], box.x() / cell, 1);
        }
    }
    const GridFrame endless = GridFrame::cover(
        Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d(1e12, 1, 1)), 1, 0);
    EXPECT_EQ(endless.count[0], kMostCellsAlong);
    EXPECT_EQ(endless.coordinate(5e11, 0), endless.count[0] - 1) << "the last cell has the rest";
}

// The sites in bricks are those of the whole box, and close alike.
TEST_P(SiteLatticeOf, IsTheSameInBricks)
{
    Scene scene = presetScene(Preset::fast, GetParam());
    scene.spheres.count.reset();
    const TriangleMesh mesh = builtInMesh(GetParam());
    scene.spheres.radius = boundingBox(mesh).sizes().maxCoeff() / 50;
    const World world(scene, mesh);
    Threads two(2);
    SiteLattice whole(world.surface, world.inside, 1, two);
    SiteLattice bricks(world.surface, world.inside, 1, two, 0, 0);
    using Place = std::array<double, 3>;
    const auto placeOf = [](const SiteLattice& sites, std::size_t site)
    {
        const Eigen::Vector3d p = sites.centre(site);
        return Place{p.x(), p.y(), p.z()};
    };
    const auto openOf = [&](const SiteLattice& sites)
    {
        std::vector<Place> open;
        for (std::size_t k = sites.nextOpen(0); k < sites.end(); k = sites.nextOpen(k + 1))
        {
            open.push_back(placeOf(sites, k));
        }
        std::sort(open.begin(), open.end());
        return open;
    };
    const auto highestOf = [&](const SiteLattice& sites)
    {
        std::vector<Place> highest;
        for (const std::uint32_t site : sites.highest())
        {
            highest.push_back(placeOf(sites, site));
        }
        std::sort(highest.begin(), highest.end());
        return highest;
    };
    const auto expectSame = [&]
    {
        EXPECT_GT(openOf(whole).size(), 1000U);
        EXPECT_EQ(openOf(whole), openOf(bricks));
        EXPECT_EQ(highestOf(whole), highestOf(bricks));
    };
    expectSame();
    const Eigen::Vector3d half = world.surface.box().sizes() / 2;
    for (std::uint64_t k = 0; k < 300; ++k)
    {
        Eigen::Vector3d p = world.surface.box().center();
        for (int axis = 0; axis < 3; ++axis)
        {
            p[axis] += half[axis] * (2 * uniformRandom(5, k, static_cast<std::uint64_t>(axis)) - 1);
        }
        whole.close(p, 1);
        bricks.close(p, 1);
    }
    expectSame();
}

INSTANTIATE_TEST_SUITE_P(Objects, SiteLatticeOf,
                         ::testing::Values("torus", "sphere", "cube", "human"),
                         [](const auto& parameter) { return std::string(parameter.param); });

} // namespace
} // namespace frostfill

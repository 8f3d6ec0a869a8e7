// SPDX-License-Identifier: MIT
#include "simulation/release/site_lattice.hpp"

#include "simulation/world/world.hpp"

#include <gtest/gtest.h>

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
    for (const double radius : {1.0, 0.6})
    {
        const SiteLattice sites(world.surface, world.inside, radius, two);
        const double least = radius - sites.halfDiagonal();
        std::size_t open = 0;
        for (std::size_t site = 0; site < sites.lattice().size(); ++site)
        {
            // A lattice is quick because most sites are decided by those beside them. Each alone:
            const bool isFarEnough = world.inside.distance(sites.centre(site)) >= least;
            ASSERT_EQ(sites.isOpen(site), isFarEnough) << site;
            open += isFarEnough ? 1 : 0;
        }
        EXPECT_GT(open, 1000U);
    }
}

INSTANTIATE_TEST_SUITE_P(Objects, SiteLatticeOf,
                         ::testing::Values("torus", "sphere", "cube", "human"),
                         [](const auto& parameter) { return std::string(parameter.param); });

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "support/shapes.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace frostfill
{
namespace
{

struct RadiiCase
{
    Motion motion;
    double smallest; ///< the largest is 0.2
};

class RadiiThatDiffer : public ::testing::TestWithParam<RadiiCase>
{
protected:
    [[nodiscard]] static Scene scene(std::uint64_t seed)
    {
        Scene result = presetScene(Preset::fast, "torus");
        result.motion.mode = GetParam().motion;
        result.spheres.count.reset();
        result.spheres.radius = Radii(GetParam().smallest, 0.2);
        result.seed = seed;
        return result;
    }
    [[nodiscard]] static std::unique_ptr<Simulation> finished(const Scene& scene)
    {
        auto simulation = std::make_unique<Simulation>(scene, shapes::torus());
        while (simulation->step())
        {
        }
        return simulation;
    }
};

// The oracle is every pair, with the radii and places that the files would have.
double deepestOverlap(const Simulation& simulation)
{
    std::vector<SphereRecord> spheres;
    for (std::size_t id = 0; id < simulation.sphereCount(); ++id)
    {
        spheres.push_back(simulation.sphere(id));
    }
    double deepest = 0;
    for (std::size_t i = 0; i < spheres.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            const double depth = spheres[i].radius + spheres[j].radius -
                                 (spheres[i].centre - spheres[j].centre).norm();
            deepest = std::max(deepest, depth / std::min(spheres[i].radius, spheres[j].radius));
        }
    }
    return deepest;
}

TEST_P(RadiiThatDiffer, FillUntilFullWithoutOverlapAndWithoutASphereInTheAir)
{
    const auto simulation = finished(scene(1));
    EXPECT_TRUE(simulation->full());
    EXPECT_EQ(simulation->restingCount(), simulation->sphereCount());
    EXPECT_LT(deepestOverlap(*simulation), 1e-9);
    const QualityReport quality = simulation->quality();
    EXPECT_LT(quality.maxOverlap, 1e-9);
    EXPECT_LT(quality.maxWallOverlap, 1e-6);
    EXPECT_EQ(quality.unsupported, 0u);
    EXPECT_EQ(quality.centresOutside, 0u);
    EXPECT_EQ(quality.notFinite, 0u);
    double sum = 0;
    for (std::size_t id = 0; id < simulation->sphereCount(); ++id)
    {
        const double radius = simulation->sphere(id).radius;
        EXPECT_GE(radius, GetParam().smallest * (1 - 1e-15));
        EXPECT_LE(radius, 0.2 * (1 + 1e-15));
        sum += std::pow(radius, 3) * 4 / 3 * M_PI;
    }
    EXPECT_NEAR(quality.sphereVolume, sum, 1e-12);
}

TEST_P(RadiiThatDiffer, GiveTheSameBitsWithAndWithoutExactDiscards)
{
    Scene with = scene(5);
    Scene without = with;
    without.discard.rule = DiscardRule::none;
    EXPECT_EQ(finished(with)->stateHash(), finished(without)->stateHash());
}

TEST_P(RadiiThatDiffer, GiveTheSameBitsWithAnyNumberOfThreads)
{
    Scene chosen = scene(3);
    chosen.spheres.groupSize = 50; // enough at once to be shared out
    chosen.spheres.count = 200;
    chosen.threads = 1;
    const std::string one = finished(chosen)->stateHash();
    for (const int threads : {2, 8})
    {
        chosen.threads = threads;
        EXPECT_EQ(finished(chosen)->stateHash(), one) << threads;
    }
}

TEST_P(RadiiThatDiffer, FollowTheSeed)
{
    Scene chosen = scene(1);
    chosen.spheres.count = 20;
    const auto first = finished(chosen);
    const auto again = finished(chosen);
    chosen.seed = 2;
    const auto other = finished(chosen);
    for (std::size_t id = 0; id < 20; ++id)
    {
        EXPECT_EQ(first->sphere(id).radius, again->sphere(id).radius);
        EXPECT_NE(first->sphere(id).radius, other->sphere(id).radius);
    }
}

std::string nameOfCase(const ::testing::TestParamInfo<RadiiCase>& info)
{
    const char* motions[] = {"Fall", "Skip", "Descend"};
    return motions[static_cast<std::size_t>(info.param.motion)] +
           std::to_string(std::lround(1000 * info.param.smallest));
}

INSTANTIATE_TEST_SUITE_P(
    FromThousandths, RadiiThatDiffer,
    ::testing::Values(RadiiCase{Motion::fall, 0.1}, RadiiCase{Motion::fall, 0.04},
                      RadiiCase{Motion::skip, 0.1}, RadiiCase{Motion::skip, 0.04},
                      RadiiCase{Motion::descend, 0.15}, RadiiCase{Motion::descend, 0.1},
                      RadiiCase{Motion::descend, 0.04}),
    nameOfCase);

TEST(RadiiOfThePaper, DifferAndStayInsideAndApartByTheirRadii)
{
    Scene scene = presetScene(Preset::paper, "torus");
    scene.spheres.radius = Radii(0.08, 0.2);
    scene.spheres.count = 60;
    Simulation simulation(scene, shapes::torus());
    while (simulation.step())
    {
    }
    EXPECT_EQ(simulation.sphereCount(), 60u);
    const QualityReport quality = simulation.quality();
    EXPECT_EQ(quality.centresOutside, 0u);
    EXPECT_LT(quality.meanOverlap, 0.1);
    EXPECT_LT(quality.maxWallOverlap, 0.1);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "scene/size_ledger.hpp"
#include "simulation/motion/drop_and_roll.hpp"
#include "simulation/release/release_rule.hpp"
#include "simulation/world/world.hpp"
#include "support/expect_error.hpp"
#include "support/shapes.hpp"
#include "support/temporary_folder.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <vector>

namespace frostfill
{
namespace
{

using test::expectError;
using test::TemporaryFolder;

class SizesOfARun : public ::testing::Test
{
protected:
    /// A cube of edge 2.
    [[nodiscard]] Scene scene(const std::string& text, Motion motion = Motion::descend) const
    {
        std::ofstream(file) << text;
        Scene result = presetScene(Preset::fast, "cube");
        result.spheres.count.reset();
        result.spheres.sizes.curve = file;
        result.motion.mode = motion;
        return result;
    }
    [[nodiscard]] static Simulation finished(const Scene& scene)
    {
        Simulation simulation(scene, builtInMesh("cube"));
        while (simulation.step())
        {
        }
        return simulation;
    }
    static void expectSound(const Simulation& simulation)
    {
        const QualityReport quality = simulation.quality();
        EXPECT_LE(quality.maxOverlap, 1e-7);
        EXPECT_LE(quality.maxWallOverlap, 1e-7);
        EXPECT_EQ(quality.centresOutside, 0U);
        EXPECT_EQ(quality.unsupported, 0U);
    }

    TemporaryFolder folder;
    std::string file = (folder.path() / "sizes.csv").string();
};

// The oracle is the curve itself: 1:10, a line of the mass. Independent draws of 100,000 miss it by
// some 0.7 %.
TEST(SizeDraws, AreTheCurveByMassWithinHalfAPerCentAtAnyPointOfARun)
{
    const SizeCurve curve({{0.1, 1, 1}}, SizeCurve::kMass, {0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1});
    for (const std::uint64_t seed : {1, 2, 3})
    {
        SizeLedger ledger(curve);
        for (std::uint64_t n = 1; n <= 100000; ++n)
        {
            ledger.add(curve.quantile(evenRandom(seed, n)));
            if (n >= 20000 && n % 5000 == 0)
            {
                EXPECT_LE(ledger.deviation(), 0.005) << n;
            }
        }
        EXPECT_LE(ledger.deviation(), 0.0015);
    }
    EXPECT_NE(evenRandom(1, 1), evenRandom(2, 1));
}

TEST_F(SizesOfARun, AreKeptWithinTheLimitUntilFullInEachMotion)
{
    for (const Motion motion : {Motion::descend, Motion::skip})
    {
        Scene one = scene("diameter,cumulative mass\n0.1,0\n0.3,100\n", motion);
        one.spheres.sizes.within = 0.02;
        const Simulation run = finished(one);
        ASSERT_TRUE(run.sizes());
        EXPECT_TRUE(run.full());
        EXPECT_LE(run.sizes()->deviation, 0.02);
        EXPECT_GT(run.sphereCount(), 1500U);
        expectSound(run);
    }
}

// 400 spheres of 1:5 and 1:20, of which a few large ones are most of the mass.
TEST_F(SizesOfARun, AreSoundInAFallAndWhenAllRestTogether)
{
    for (const char* curve : {"radius,cumulative mass\n0.03,0\n0.15,100\n",
                              "radius,cumulative mass\n0.012,0\n0.24,100\n"})
    {
        for (const Rest rest : {Rest::each, Rest::joint})
        {
            Scene one = scene(curve, rest == Rest::joint ? Motion::skip : Motion::fall);
            one.spheres.count = 400;
            one.rest.mode = rest;
            one.rest.friction = rest == Rest::joint ? 0.3 : 0;
            const Simulation run = finished(one);
            EXPECT_EQ(run.sphereCount(), 400U);
            expectSound(run);
            EXPECT_LE(run.quality().energyExcess, 1e-12);
        }
    }
}

TEST_F(SizesOfARun, GoOnWithoutALimitAndSayHowFarTheyAreOff)
{
    Scene bound = scene("diameter,cumulative mass\n0.1,0\n0.4,100\n");
    Scene unbound = bound;
    unbound.spheres.sizes.within.reset();
    const Simulation first = finished(bound);
    const Simulation second = finished(unbound);
    EXPECT_GT(second.sphereCount(), first.sphereCount());
    EXPECT_GT(second.quality().sphereVolume, first.quality().sphereVolume);
    EXPECT_GT(second.sizes()->deviation, first.sizes()->deviation);
    // The report, from the spheres themselves.
    double below = 0;
    double all = 0;
    const SizeReport sizes = *second.sizes();
    for (std::size_t id = 0; id < second.sphereCount(); ++id)
    {
        const double radius = second.sphere(id).radius;
        all += std::pow(radius, 3);
        below += radius <= sizes.at ? std::pow(radius, 3) : 0;
    }
    EXPECT_NEAR(std::abs(below / all - (sizes.at - 0.05) / 0.15), sizes.deviation, 1e-9);
    expectSound(second);
}

// In the end there is room for none but the smallest. With these the draw of that is a little
// larger by rounding.
TEST_F(SizesOfARun, EndWithoutALimitWhateverTheSmallestIs)
{
    for (const std::string smallest : {"0.1025", "0.1309", "0.1312", "0.1317", "0.1336"})
    {
        Scene one = scene("radius,cumulative mass\n" + smallest + ",0\n0.2,100\n");
        one.spheres.sizes.within.reset();
        const Simulation run = finished(one);
        EXPECT_TRUE(run.full());
        EXPECT_GT(run.sphereCount(), 150U);
    }
}

TEST_F(SizesOfARun, FillTheGapsOfTheLargestInTheSharesAskedFor)
{
    Scene one = scene("radius,volume share\n0.05,0.1\n0.2,0.9\n");
    one.spheres.sizes.fillGaps = true;
    const Simulation run = finished(one);
    expectSound(run);
    EXPECT_LE(run.sizes()->deviation, 0.002);
    // Small ones come last, and go anywhere: many lie below the middle of the large.
    std::size_t large = 0;
    std::size_t low = 0;
    for (std::size_t id = 0; id < run.sphereCount(); ++id)
    {
        const SphereRecord sphere = run.sphere(id);
        const bool isLarge = sphere.radius > 0.1;
        EXPECT_TRUE(!isLarge || id == large) << id;
        large += isLarge ? 1 : 0;
        low += !isLarge && sphere.centre.y() < 0 ? 1 : 0;
    }
    EXPECT_GT(low, (run.sphereCount() - large) / 4);
    // As many as the shares say: 0.1 / 0.9 of the volume, of a 64th each.
    EXPECT_NEAR(static_cast<double>(run.sphereCount() - large), static_cast<double>(large) * 64 / 9,
                1.5);
    Scene plain = one;
    plain.spheres.sizes.fillGaps = false;
    EXPECT_GT(run.quality().sphereVolume, finished(plain).quality().sphereVolume);
}

TEST_F(SizesOfARun, AreCountedInGapsToo)
{
    Scene one = scene("radius,mass share\n0.05,0.2\n0.1,0.3\n0.2,0.5\n");
    one.spheres.sizes.fillGaps = true;
    one.spheres.count = 500;
    const Simulation run = finished(one);
    EXPECT_EQ(run.sphereCount(), 500U);
    EXPECT_FALSE(run.full());
    EXPECT_LE(run.sizes()->deviation, 0.01);
}

TEST_F(SizesOfARun, AreTheSameOnAnyNumberOfThreadsAndWithoutDiscards)
{
    for (const bool gaps : {false, true})
    {
        Scene one = scene("diameter,cumulative number\n0.1,0\n0.3,100\n");
        one.spheres.sizes.fillGaps = gaps;
        one.threads = 1;
        const std::string hash = finished(one).stateHash();
        one.threads = 2;
        EXPECT_EQ(finished(one).stateHash(), hash);
        one.discard.rule = DiscardRule::none;
        EXPECT_EQ(finished(one).stateHash(), hash);
    }
}

TEST_F(SizesOfARun, AreRefusedWhenTheLargestDoesNotFit)
{
    for (const bool gaps : {false, true})
    {
        Scene one = scene("radius,mass share\n0.1,0.5\n1.2,0.5\n");
        one.spheres.sizes.fillGaps = gaps;
        expectError(
            ErrorCode::badData, [&] { Simulation(one, builtInMesh("cube")); }, "1.2", "--sizes");
    }
}

// The oracle is every sphere. Places overlap, which a search does not mind.
class SizesInLevels : public ::testing::Test
{
protected:
    SizesInLevels()
    {
        Scene scene = presetScene(Preset::fast, "cube");
        scene.spheres.sizes = {.curve = "lognormal:0.1,0.1,0.0125..0.25", .by = SharesOf::mass};
        world.emplace(scene, builtInMesh("cube"));
        for (int k = 0; k < 600; ++k)
        {
            const double radius = world->radii.curve()->quantile(draw());
            world->spheres.addResting(point(), radius, 0);
        }
    }
    double draw() { return uniformRandom(7, ++draws, 0); }
    Eigen::Vector3d point()
    {
        const double half = world->height / 2;
        const double x = half * (2 * draw() - 1);
        const double y = half * (2 * draw() - 1);
        return {x, y, half * (2 * draw() - 1)};
    }

    std::optional<World> world;
    std::uint64_t draws = 0;
};

TEST_F(SizesInLevels, SearchesFindAllThatIsNearOnce)
{
    const SphereGrid& resting = world->spheres.resting();
    EXPECT_EQ(resting.levels(), 4U);
    for (int k = 0; k < 300; ++k)
    {
        const Eigen::Vector3d p = point();
        const double radius = k % 2 == 0 ? 1 : 0.05;
        std::vector<int> seen(resting.size());
        resting.forEachNear(p, radius + 1 + 0.1, [&](std::uint32_t row) { ++seen[row]; });
        for (std::uint32_t row = 0; row < resting.size(); ++row)
        {
            EXPECT_LE(seen[row], 1);
            const double distance = (resting[row].position() - p).norm();
            EXPECT_TRUE(seen[row] == 1 || distance > radius + resting[row].radius + 0.1);
        }
    }
}

TEST_F(SizesInLevels, FallsEndAtTheFirstSphereOfAnySize)
{
    const SphereGrid& resting = world->spheres.resting();
    int onSpheres = 0;
    for (int k = 0; k < 500; ++k)
    {
        const double radius = k % 2 == 0 ? 1 : 0.0625;
        Eigen::Vector3d p = point();
        p.x() *= 1 - 2 * radius / world->height; // clear of walls
        p.z() *= 1 - 2 * radius / world->height;
        double highest = radius - world->height / 2; // on the floor
        bool touches = false;
        for (std::uint32_t row = 0; row < resting.size(); ++row)
        {
            const Eigen::Vector3d away = resting[row].position() - p;
            const double reach = radius + resting[row].radius;
            touches = touches || away.norm() < reach;
            const double squared = reach * reach - away.x() * away.x() - away.z() * away.z();
            if (squared > 0 && away.y() < 0)
            {
                highest = std::max(highest, resting[row].y + std::sqrt(squared));
            }
        }
        if (touches || p.y() < highest)
        {
            continue; // no place to fall from
        }
        Vector3d dropped = p;
        ASSERT_TRUE(DropAndRoll(*world).drop(dropped, radius));
        EXPECT_NEAR(dropped.y(), highest, 1e-9);
        onSpheres += highest > radius - world->height / 2 + 1e-6 ? 1 : 0;
    }
    EXPECT_GT(onSpheres, 20);
}

} // namespace
} // namespace frostfill

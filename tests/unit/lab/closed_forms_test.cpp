// SPDX-License-Identifier: MIT
#include "lab/closed_forms.hpp"

#include "lab/meshes.hpp"

#include <frostfill/simulation.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace frostfill
{
namespace
{

TEST(ClosedForms, AllThatIsClaimedHolds)
{
    const std::vector<ClosedFormPoint> points = measureClosedForms(true);
    EXPECT_GT(points.size(), 50U);
    for (const ClosedFormPoint& point : points)
    {
        EXPECT_TRUE(point.holds())
            << point.problem << ", " << point.method << ", " << point.parameter << " "
            << point.value << ": " << point.error << " against " << point.expected;
    }
}

TEST(ClosedForms, HoldOnlyWhenAPredictionIsMetOrABoundIsKept)
{
    ClosedFormPoint point{"fall", "Euler", "step", 0.1, 0.5, 0.5, true};
    EXPECT_TRUE(point.holds());
    point.error = 0.5 + 1e-8;
    EXPECT_FALSE(point.holds());
    point.exact = false;
    EXPECT_FALSE(point.holds());
    point.error = -0.4;
    EXPECT_TRUE(point.holds());
}

TEST(FreezingBySet, PacksMoreDenselyTheMoreLayersASetHas)
{
    const TriangleMesh mesh = cutBoxMesh({-6, -6, -6}, {6, 6, 6}, 4);
    double last = 0;
    for (const std::uint32_t setSize : {4u, 60u, 240u})
    {
        Scene scene = presetScene(Preset::fast, "cube");
        scene.spheres.radius = 0.5;
        scene.spheres.count.reset();
        scene.motion.restitution = 0;
        scene.freezing.rule = FreezingRule::bySet;
        scene.spheres.groupSize = setSize;
        scene.spheres.groupsPerSet = 1;
        scene.threads = 1;
        Simulation simulation(scene, mesh);
        while (simulation.step())
        {
        }
        const QualityReport quality = simulation.quality();
        const double fraction = quality.sphereVolume / quality.meshVolume;
        EXPECT_GT(fraction, last);
        EXPECT_LT(quality.maxOverlap, 1e-7);
        EXPECT_EQ(quality.unsupported, 0u);
        last = fraction;
    }
}

/// Mean depth of the overlaps of running spheres. [r]
double movingOverlap(const Snapshot& state)
{
    double sum = 0;
    double pairs = 0;
    for (std::size_t i = 0; i < state.centres.size(); ++i)
    {
        for (std::size_t j = 0; j < state.centres.size(); ++j)
        {
            const bool counts = state.states[i] == SphereState::running && i != j &&
                                (j > i || state.states[j] != SphereState::running);
            const double depth = 2 - (state.centres[i] - state.centres[j]).norm() / state.radii[i];
            if (counts && depth > 0)
            {
                sum += depth;
                ++pairs;
            }
        }
    }
    return sum / std::max(pairs, 1.0);
}

TEST(ContactSweeps, TakeRunningSpheresFartherApart)
{
    double overlap[2] = {};
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
    {
        for (const int many : {0, 1})
        {
            Scene scene = presetScene(Preset::fast, "cube");
            scene.spheres.radius = 0.1;
            scene.spheres.count = 100;
            scene.seed = seed;
            scene.motion.mode = Motion::skip;
            scene.motion.sweeps = many == 1 ? 16 : 1;
            Simulation simulation(scene, builtInMesh("cube"));
            Snapshot state;
            double looks = 0;
            double sum = 0;
            while (simulation.step())
            {
                if (simulation.steps() % 5 == 0)
                {
                    simulation.capture(state);
                    sum += movingOverlap(state);
                    ++looks;
                }
            }
            overlap[many] += sum / looks;
        }
    }
    EXPECT_LT(overlap[1], 0.5 * overlap[0]);
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "lab/closed_forms.hpp"

#include "lab/finish_run.hpp"
#include "lab/meshes.hpp"

#include <gtest/gtest.h>

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
    const TriangleMesh mesh = boxMesh({-6, -6, -6}, {6, 6, 6}, 4);
    double last = 0;
    for (const std::uint32_t setSize : {4u, 60u, 240u})
    {
        Scene scene = studyScene(Preset::fast, "cube", 0.5);
        scene.motion.restitution = 0;
        scene.freezing.bySet = true;
        scene.spheres.groupSize = setSize;
        scene.spheres.groupsPerSet = 1;
        const Finished run = finishRun(scene, mesh);
        const double fraction = run.quality.sphereVolume / run.quality.meshVolume;
        EXPECT_GT(fraction, last);
        EXPECT_LT(run.quality.maxOverlap, 1e-7);
        EXPECT_EQ(run.quality.unsupported, 0u);
        last = fraction;
    }
}

TEST(ContactSweeps, TakeRunningSpheresFartherApart)
{
    const TriangleMesh mesh = builtInMesh("cube");
    double overlap[2] = {};
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
    {
        for (const int many : {0, 1})
        {
            Scene scene = studyScene(Preset::fast, "cube", 0.1);
            scene.seed = seed;
            scene.spheres.count = 100;
            scene.motion.mode = Motion::skip;
            scene.motion.sweeps = many == 1 ? 16 : 1;
            overlap[many] += finishRun(scene, mesh, 0.5).meanMovingOverlap;
        }
    }
    EXPECT_LT(overlap[1], 0.5 * overlap[0]);
}

} // namespace
} // namespace frostfill

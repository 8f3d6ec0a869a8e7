// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <frostfill/error.hpp>
#include <frostfill/volume_estimate.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace frostfill
{
namespace
{

TEST(VolumeEstimate, IsWithinOnePercentOfTheMeshAndOfItsUncertainty)
{
    for (const char* mesh : {"cube", "sphere", "torus"})
    {
        Scene scene = presetScene(Preset::fast, mesh);
        scene.motion.mode = Motion::descend;
        const VolumeEstimate estimate = estimateVolume(scene);
        const double error = std::abs(estimate.volume - estimate.meshVolume);
        EXPECT_LT(error, 0.01 * estimate.meshVolume) << mesh;
        EXPECT_LT(error, 1.5 * estimate.error) << mesh;
        EXPECT_GT(estimate.fine, 7 * estimate.coarse) << mesh;
    }
}

TEST(VolumeEstimate, IsRefusedForRadiiThatDiffer)
{
    Scene scene = presetScene(Preset::fast, "cube");
    scene.spheres.radius = Radii(0.1, 0.2);
    test::expectError(
        ErrorCode::usage, [&] { (void)estimateVolume(scene); }, "estimate of a volume", "radius");
}

} // namespace
} // namespace frostfill

// SPDX-License-Identifier: MIT
#include "scene/packing_estimate.hpp"

#include <frostfill/error.hpp>
#include <frostfill/simulation.hpp>
#include <frostfill/volume_estimate.hpp>

#include <cmath>

namespace frostfill
{
namespace
{

/// Of the coarse spheres, when the scene has no radius. The calibration is for up to 0.3.
constexpr double kRadiusTimesAreaOverVolume = 0.2;
/// Coarse fillings, which cost an eighth of a fine one each and scatter more.
constexpr std::size_t kCoarseFillings = 4;

std::size_t fitting(Scene scene, const TriangleMesh& mesh, double radius,
                    const std::function<bool()>& stopRequested)
{
    scene.spheres.radius = radius;
    scene.spheres.count.reset();
    Simulation simulation(scene, mesh);
    simulation.stopWhen(stopRequested);
    while (simulation.step())
    {
        if (stopRequested && stopRequested())
        {
            throw Error(ErrorCode::stoppedEarly, "the estimate of the volume was stopped");
        }
    }
    return simulation.sphereCount();
}

} // namespace

VolumeEstimate estimateVolume(const Scene& scene)
{
    return estimateVolume(scene, loadMesh(scene.object.mesh, scene.object.load));
}

VolumeEstimate estimateVolume(const Scene& scene, const LoadedMesh& mesh,
                              const std::function<bool()>& stopRequested)
{
    validateScene(scene);
    if (!scene.spheres.inlets.empty())
    {
        throw Error(ErrorCode::usage,
                    "the estimate of a volume needs an object that is filled everywhere: "
                    "omit --inlet");
    }
    if (scene.spheres.sizes.curve || (scene.spheres.radius && !scene.spheres.radius->equal()))
    {
        throw Error(ErrorCode::usage,
                    "the estimate of a volume needs one radius: the packing fraction is "
                    "known for equal spheres only");
    }
    VolumeEstimate estimate;
    estimate.meshVolume = mesh.report.volume;
    const double depth = mesh.report.volume / mesh.report.area;
    estimate.radius =
        scene.spheres.radius ? scene.spheres.radius->largest : kRadiusTimesAreaOverVolume * depth;
    estimate.radiusTimesAreaOverVolume = estimate.radius / depth;
    for (std::size_t filling = 0; filling < kCoarseFillings; ++filling)
    {
        Scene coarse = scene;
        coarse.seed += filling;
        estimate.coarse += fitting(coarse, mesh.mesh, estimate.radius, stopRequested);
    }
    estimate.fine = fitting(scene, mesh.mesh, estimate.radius / 2, stopRequested);

    const PackingCalibration packing = packingCalibration(scene);
    const double coarse = static_cast<double>(estimate.coarse) / kCoarseFillings;
    estimate.coarse = static_cast<std::size_t>(std::lround(coarse));
    const auto fine = static_cast<double>(estimate.fine);
    const double one = 4.0 / 3.0 * M_PI * std::pow(estimate.radius, 3) / packing.ruleFraction;
    estimate.volume = one * (fine / 4 - coarse);
    const double ofShape =
        estimate.volume * packing.ruleError * growthOfError(estimate.radiusTimesAreaOverVolume);
    const double ofFine = one * fine / 4 * scatterOfCount(fine);
    const double ofCoarse = one * coarse * scatterOfCount(coarse * kCoarseFillings);
    estimate.error = std::hypot(ofShape, ofFine, ofCoarse);
    return estimate;
}

} // namespace frostfill

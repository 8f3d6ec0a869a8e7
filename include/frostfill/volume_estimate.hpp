// SPDX-License-Identifier: MIT
#pragma once

#include <frostfill/mesh.hpp>
#include <frostfill/scene.hpp>

#include <cstddef>
#include <functional>

#pragma GCC visibility push(default)
namespace frostfill
{

/// An object's volume as its fillings with spheres tell it.
struct VolumeEstimate
{
    double radius = 0;      ///< [mesh unit] of the coarse spheres; the fine ones have half of it
    std::size_t coarse = 0; ///< spheres of the radius that fit, a mean over seeds
    std::size_t fine = 0;   ///< spheres of half the radius that fit
    double volume = 0;      ///< [unit^3]
    double error = 0;       ///< [unit^3] uncertainty: that of the calibration over shapes, and the
                            ///< scatter between packings, added as squares
    double meshVolume = 0;  ///< [unit^3] of the mesh itself, to compare with
    double radiusTimesAreaOverVolume = 0; ///< r S / V of the coarse spheres
};

/// Fills the scene's object until full with r, several times, and with r/2, and extrapolates:
/// (2 N(r/2) v(r/2) - N(r) v(r)) / phi. What the walls take away grows with r, so it drops out
/// without the surface being known. r is the scene's radius, or 0.2 V/S when it gives none.
/// Throws Error usage for radii that differ, and what loadMesh and Simulation throw.
[[nodiscard]] VolumeEstimate estimateVolume(const Scene& scene);

/// The same for a mesh that is loaded, in place of the scene's. `stopRequested` may be empty; it is
/// asked often, and once it is true Error stoppedEarly is thrown.
[[nodiscard]] VolumeEstimate estimateVolume(const Scene& scene, const LoadedMesh& mesh,
                                            const std::function<bool()>& stopRequested = {});

} // namespace frostfill
#pragma GCC visibility pop

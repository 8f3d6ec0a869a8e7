// SPDX-License-Identifier: MIT
#pragma once

#include "simulation/world/world.hpp"

#include <frostfill/scene.hpp>

#include <memory>

namespace frostfill
{

/// A scene for a study: until full, with one thread, and searches by grid, which give the same bits
/// as all pairs, sooner.
[[nodiscard]] Scene studyScene(Preset preset, const std::string& mesh, double radius);

/// A run to its end, with its quality and time.
struct Finished
{
    std::unique_ptr<World> world;
    QualityReport quality;
    double movingOverlap = 0;     ///< [r] mean over time of the running spheres' largest
    double meanMovingOverlap = 0; ///< [r] mean over time of their mean, over pairs that overlap
    double seconds = 0;           ///< of processor time
};

/// `lookEvery`: how often the running spheres are looked at [sqrt(r/g)]; 0 for never.
[[nodiscard]] Finished finishRun(const Scene& scene, const TriangleMesh& mesh,
                                 double lookEvery = 0);

} // namespace frostfill
